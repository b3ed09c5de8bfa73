// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <bit>
#include <cctype>
#include <cstdint>
#include <cstring>
#include <limits>

#include "cvo_slam/io/image_header_internal.h"

namespace cvo_slam {
namespace {

/// Numbers in the bytes of a file. What lies behind the end reads as 0.
class Bytes {
 public:
  Bytes(std::string_view bytes, std::endian order) : bytes_(bytes), order_(order) {}

  [[nodiscard]] std::size_t size() const { return bytes_.size(); }
  [[nodiscard]] std::uint32_t at(std::size_t position) const {
    return position < bytes_.size() ? static_cast<unsigned char>(bytes_[position]) : 0U;
  }
  [[nodiscard]] std::uint32_t word(std::size_t position, std::size_t count) const {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t k = order_ == std::endian::big ? i : count - 1 - i;
      value = value << 8U | at(position + k);
    }
    return value;
  }

 private:
  std::string_view bytes_;
  std::endian order_;
};

int side(std::uint32_t value) {
  constexpr auto kMost = static_cast<std::uint32_t>(std::numeric_limits<int>::max());
  return static_cast<int>(std::min(value, kMost));
}

/// Walks over the chunks: length, name, data, checksum (PNG specification, 5.3).
ImageHeader parse_png(std::string_view text) {
  const Bytes bytes(text, std::endian::big);
  ImageHeader header{{side(bytes.word(16, 4)), side(bytes.word(20, 4))}, false};
  constexpr std::size_t kSignature = 8;
  constexpr std::size_t kAround = 12;
  for (std::size_t at = kSignature; at + kAround <= text.size();) {
    const std::size_t next = at + kAround + bytes.word(at, 4);
    if (text.substr(at + 4, 4) == "IEND") {
      header.is_whole = next <= text.size();
      break;
    }
    at = next;
  }
  return header;
}

/// Walks over the segments: 0xff, marker, length, data (ITU-T T.81, B.1.1). Behind a start of scan
/// the coded image follows, in which 0xff is followed by 0 or by a restart marker.
ImageHeader parse_jpeg(std::string_view text) {
  constexpr std::uint32_t kEnd = 0xd9;
  constexpr std::uint32_t kScan = 0xda;
  constexpr std::uint32_t kFirstRestart = 0xd0;
  constexpr std::uint32_t kLastRestart = 0xd7;
  const auto is_frame = [](std::uint32_t marker) {  // start of frame; c4, c8 and cc are tables
    return marker >= 0xc0 && marker <= 0xcf && marker != 0xc4 && marker != 0xc8 && marker != 0xcc;
  };
  const Bytes bytes(text, std::endian::big);
  ImageHeader header{{}, false};
  for (std::size_t at = 2; at + 1 < text.size();) {
    const std::uint32_t marker = bytes.at(at + 1);
    if (bytes.at(at) != 0xff || marker == 0xff || marker == 0 ||
        (marker >= kFirstRestart && marker <= kLastRestart)) {
      ++at;  // padding, or within the coded image
      continue;
    }
    if (marker == kEnd) {
      header.is_whole = true;
      break;
    }
    if (is_frame(marker) && header.size.empty()) {
      header.size = {static_cast<int>(bytes.word(at + 7, 2)),
                     static_cast<int>(bytes.word(at + 5, 2))};
    }
    at += 2 + bytes.word(at + 2, 2);
    if (marker != kScan) continue;
    while (at + 1 < text.size() && (bytes.at(at) != 0xff || bytes.at(at + 1) == 0)) ++at;
  }
  return header;
}

/// Reads "P5 width height": words between blanks and comments.
ImageHeader parse_pnm(std::string_view text) {
  std::size_t at = 2;
  const auto number = [&]() {
    while (at < text.size() &&
           (std::isspace(static_cast<unsigned char>(text[at])) != 0 || text[at] == '#')) {
      if (text[at] == '#') at = std::min(text.find('\n', at), text.size() - 1);
      ++at;
    }
    std::uint32_t value = 0;
    for (; at < text.size() && text[at] >= '0' && text[at] <= '9'; ++at) {
      if (value > 1'000'000) break;  // no image is so wide
      value = 10 * value + static_cast<std::uint32_t>(text[at] - '0');
    }
    return side(value);
  };
  const int width = number();
  return {{width, number()}, true};
}

ImageHeader parse_bmp(std::string_view text) {
  const Bytes bytes(text, std::endian::little);
  const auto height = static_cast<std::int32_t>(bytes.word(22, 4));  // negative: from top to bottom
  return {{side(bytes.word(18, 4)), height < 0 ? side(0U - bytes.word(22, 4)) : height}, true};
}

/// Reads the first directory: entries of 12 bytes, tag, type, count, value (TIFF 6.0, section 2).
ImageHeader parse_tiff(std::string_view text, std::endian order) {
  constexpr std::uint32_t kWidth = 256;
  constexpr std::uint32_t kHeight = 257;
  constexpr std::uint32_t kShort = 3;
  const Bytes bytes(text, order);
  const std::size_t directory = bytes.word(4, 4);
  ImageHeader header;
  for (std::size_t i = 0; i < bytes.word(directory, 2); ++i) {
    const std::size_t entry = directory + 2 + 12 * i;
    if (entry >= text.size()) break;
    const std::uint32_t tag = bytes.word(entry, 2);
    const int value = side(bytes.word(entry + 8, bytes.word(entry + 2, 2) == kShort ? 2 : 4));
    if (tag == kWidth) header.size.width = value;
    if (tag == kHeight) header.size.height = value;
  }
  return header;
}

}  // namespace

std::optional<ImageHeader> parse_image_header(std::string_view bytes) {
  using namespace std::string_view_literals;
  if (bytes.starts_with("\x89PNG\r\n\x1a\n"sv)) return parse_png(bytes);
  if (bytes.starts_with("\xff\xd8"sv)) return parse_jpeg(bytes);
  if (bytes.starts_with("II*\0"sv)) return parse_tiff(bytes, std::endian::little);
  if (bytes.starts_with("MM\0*"sv)) return parse_tiff(bytes, std::endian::big);
  if (bytes.starts_with("BM"sv)) return parse_bmp(bytes);
  if (bytes.size() > 2 && bytes[0] == 'P' && bytes[1] >= '1' && bytes[1] <= '6') {
    return parse_pnm(bytes);
  }
  return std::nullopt;
}

}  // namespace cvo_slam
