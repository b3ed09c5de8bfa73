// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/apps/argument_text.h"

#include <algorithm>
#include <optional>
#include <string_view>

#include <fmt/format.h>

#include "cvo_slam/core/error.h"
#include "cvo_slam/core/numbers.h"

namespace cvo_slam {
namespace {

/// One number of a range; `otherwise` if the text is empty, nothing if it is no number.
std::optional<std::size_t> parse_index(std::string_view text, std::size_t otherwise) {
  if (text.empty()) return otherwise;
  return parse_integer<std::size_t>(text);
}

}  // namespace

void apply_setting(const OptionSet& options, const std::string& setting,
                   const std::string& example) {
  const std::size_t equals = setting.find('=');
  if (equals == std::string::npos) {
    throw OptionError(fmt::format("--set {} must be key=value, e.g. {}", setting, example));
  }
  options.set(setting.substr(0, equals), setting.substr(equals + 1));
}

FrameRange parse_frames(const std::string& frames, std::size_t size) {
  if (frames.empty()) return {0, size};
  const std::string_view text = frames;
  const std::size_t colon = text.find(':');
  const std::size_t second = colon == std::string_view::npos ? colon : text.find(':', colon + 1);
  const auto part = [&](std::size_t first, std::size_t last) {
    return first == 0 ? std::string_view() : text.substr(first, last - first);
  };
  const auto begin = parse_index(text.substr(0, colon), 0);
  const auto end = parse_index(part(colon + 1, second), size);
  const auto step = parse_index(part(second + 1, text.size()), 1);
  if (colon == std::string_view::npos || !begin || !end || !step || *step == 0) {
    throw OptionError(
        fmt::format("--frames {} must be a:b, a:, :b or a:b:step, e.g. 0:100", frames));
  }
  // A longer step than the sequence is the same, and cannot overflow.
  const FrameRange range{*begin, std::min(*end, size),
                         std::min(*step, std::max<std::size_t>(size, 1))};
  if (range.begin >= range.end) {
    throw OptionError(fmt::format("--frames {} holds no frame; the sequence has {} frames, from 0",
                                  frames, size));
  }
  return range;
}

PixelSize parse_size(const std::string& text, const std::string& example) {
  const std::string_view both = text;
  const std::size_t x = std::min(both.find('x'), both.size());
  const auto width = parse_integer<int>(both.substr(0, x));
  const auto height = parse_integer<int>(both.substr(std::min(x + 1, both.size())));
  if (width && height) return {*width, *height};
  throw OptionError(fmt::format("--size {} must be <width>x<height>, e.g. {}", text, example));
}

}  // namespace cvo_slam
