// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Values that the command line spells as text.
#pragma once

#include <cstddef>
#include <string>

#include "cvo_slam/core/options.h"

namespace cvo_slam {

/// The frames begin, begin + step, ... below end of a sequence.
struct FrameRange {
  std::size_t begin = 0;
  std::size_t end = 0;
  std::size_t step = 1;

  [[nodiscard]] std::size_t size() const { return (end - begin + step - 1) / step; }
};

/// Width and height of an image [px].
struct PixelSize {
  int width = 0;
  int height = 0;
};

/// Sets the option that an argument "key=value" of --set names. Throws OptionError if the argument
/// is malformed, with `example` as a correct one, or if the set refuses it.
void apply_setting(const OptionSet& options, const std::string& setting,
                   const std::string& example);

/// Returns the frames that "a:b", "a:", ":b" or "a:b:step" names in a sequence of `size` frames; an
/// empty text means all. Throws OptionError if the text is malformed or names no frame.
[[nodiscard]] FrameRange parse_frames(const std::string& frames, std::size_t size);

/// Returns the size that "<width>x<height>" names. Throws OptionError, with `example` as a correct
/// text, if it is malformed.
[[nodiscard]] PixelSize parse_size(const std::string& text, const std::string& example);

}  // namespace cvo_slam
