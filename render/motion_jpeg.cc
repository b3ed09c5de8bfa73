// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/render/motion_jpeg.h"

#include <algorithm>
#include <cstdint>
#include <string_view>

#include <fmt/format.h>
#include <opencv2/imgcodecs.hpp>

#include "cvo_slam/core/error.h"
#include "cvo_slam/core/files.h"

namespace cvo_slam::render {
namespace {

constexpr std::uint32_t kFramesPerSecond = 25;

std::string little_endian(std::uint32_t value, int bytes) {
  std::string text;
  for (int i = 0; i < bytes; ++i) {
    text += static_cast<char>(value & 0xffU);
    value >>= 8U;
  }
  return text;
}

std::string u32(std::size_t value) { return little_endian(static_cast<std::uint32_t>(value), 4); }
std::string u16(std::uint32_t value) { return little_endian(value, 2); }

/// Returns a chunk of a RIFF file: name, length and content, padded to an even length.
std::string chunk(std::string_view name, const std::string& content) {
  return std::string(name) + u32(content.size()) + content +
         (content.size() % 2 == 0 ? "" : std::string(1, '\0'));
}

std::string list(std::string_view kind, const std::string& content) {
  return chunk("LIST", std::string(kind) + content);
}

struct Film {
  cv::Size size;
  std::size_t frames;
  std::size_t largest_frame;
};

/// Returns the AVIMAINHEADER of Microsoft's "AVI RIFF File Reference".
std::string main_header(const Film& film) {
  constexpr std::uint32_t kHasIndex = 0x10;
  return u32(1'000'000 / kFramesPerSecond) + u32(film.largest_frame * kFramesPerSecond) + u32(0) +
         u32(kHasIndex) + u32(film.frames) + u32(0) + u32(1) + u32(film.largest_frame) +
         u32(static_cast<std::size_t>(film.size.width)) +
         u32(static_cast<std::size_t>(film.size.height)) + std::string(16, '\0');
}

/// Returns AVISTREAMHEADER and BITMAPINFOHEADER (the same source).
std::string stream_headers(const Film& film) {
  const auto width = static_cast<std::uint32_t>(film.size.width);
  const auto height = static_cast<std::uint32_t>(film.size.height);
  const std::string stream = "vidsMJPG" + std::string(12, '\0') + u32(1) + u32(kFramesPerSecond) +
                             u32(0) + u32(film.frames) + u32(film.largest_frame) +
                             u32(0xffffffffU) + u32(0) + u16(0) + u16(0) + u16(width) + u16(height);
  const std::string bitmap = u32(40) + u32(width) + u32(height) + u16(1) + u16(24) + "MJPG" +
                             u32(std::size_t{3} * width * height) + std::string(16, '\0');
  return list("strl", chunk("strh", stream) + chunk("strf", bitmap));
}

}  // namespace

void MotionJpeg::add(const cv::Mat& image) {
  if (!frames_.empty() && image.size() != size_) {
    throw DataError(
        fmt::format("a picture of {2}x{3} pixels does not fit into a film of {0}x{1} pixels",
                    size_.width, size_.height, image.cols, image.rows));
  }
  size_ = image.size();
  std::vector<unsigned char> bytes;
  cv::imencode(".jpg", image, bytes, {cv::IMWRITE_JPEG_QUALITY, 90});
  frames_.emplace_back(reinterpret_cast<const char*>(bytes.data()), bytes.size());
}

void MotionJpeg::write(const std::filesystem::path& file) const {
  if (file.extension() != ".avi") {
    throw OptionError(
        fmt::format("'{}': a film must be an .avi file (Motion JPEG)", file.string()));
  }
  std::string pictures;
  std::string index;
  Film film{size_, frames_.size(), 0};
  constexpr std::uint32_t kIsWhole = 0x10;  // each picture can be decoded on its own
  for (const std::string& frame : frames_) {
    film.largest_frame = std::max(film.largest_frame, frame.size());
    // Positions are counted from the word "movi".
    index += "00dc" + u32(kIsWhole) + u32(4 + pictures.size()) + u32(frame.size());
    pictures += chunk("00dc", frame);
  }
  constexpr std::size_t kLargest = 2'000'000'000;  // readers use signed lengths
  if (frames_.empty() || pictures.size() > kLargest) {
    throw OutputError(file, frames_.empty()
                                ? "the film has no pictures; add some"
                                : "the film has more than 2 GB; make fewer or smaller pictures");
  }
  const std::string headers = list("hdrl", chunk("avih", main_header(film)) + stream_headers(film));
  write_file(file, chunk("RIFF", "AVI " + headers + list("movi", pictures) + chunk("idx1", index)));
}

}  // namespace cvo_slam::render
