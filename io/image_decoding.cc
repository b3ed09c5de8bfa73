// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <memory>
#include <type_traits>

#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <turbojpeg.h>

#include "cvo_slam/io/image_decoding_internal.h"

namespace cvo_slam {
namespace {

struct DestroyDecoder {
  void operator()(tjhandle decoder) const { tjDestroy(decoder); }
};
using Decoder = std::unique_ptr<std::remove_pointer_t<tjhandle>, DestroyDecoder>;

/// Returns the image of a JPEG file of grey values or of the usual colours; empty for any other
/// file, and if there was an error or a warning.
cv::Mat decode_jpeg(const std::string& bytes) {
  if (!bytes.starts_with("\xff\xd8")) return {};
  const Decoder decoder(tjInitDecompress());
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): bytes are char here
  const auto* data = reinterpret_cast<const unsigned char*>(bytes.data());
  int width = 0;
  int height = 0;
  int subsampling = 0;
  int colors = 0;
  if (!decoder || tjDecompressHeader3(decoder.get(), data, bytes.size(), &width, &height,
                                      &subsampling, &colors) != 0) {
    return {};
  }
  if (colors != TJCS_GRAY && colors != TJCS_YCbCr && colors != TJCS_RGB) return {};
  const bool is_grey = colors == TJCS_GRAY;
  cv::Mat image(height, width, is_grey ? CV_8UC1 : CV_8UC3);
  const int problem =
      tjDecompress2(decoder.get(), data, bytes.size(), image.data, width,
                    static_cast<int>(image.step), height, is_grey ? TJPF_GRAY : TJPF_BGR, 0);
  return problem == 0 ? image : cv::Mat();
}

}  // namespace

cv::Mat decode_image(const std::string& bytes) {
  if (cv::Mat image = decode_jpeg(bytes); !image.empty()) return image;
  try {
    // Not cv::imread, which writes a warning to stderr if a file is missing.
    const cv::Mat buffer(1, static_cast<int>(bytes.size()), CV_8UC1,
                         const_cast<char*>(bytes.data()));  // NOLINT: only read from
    return cv::imdecode(buffer, cv::IMREAD_UNCHANGED);
  } catch (const cv::Exception&) {
    return {};
  }
}

}  // namespace cvo_slam
