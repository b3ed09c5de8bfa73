// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/apps/loop_pictures.h"

#include <algorithm>
#include <array>
#include <optional>
#include <regex>
#include <set>
#include <system_error>

#include <fmt/format.h>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "cvo_slam/core/error.h"
#include "cvo_slam/core/files.h"
#include "cvo_slam/plot/figure.h"

namespace cvo_slam {
namespace {

constexpr int kGap = 8;  // [px] between the two images
/// Different enough to tell neighbouring lines apart, on dark and on bright images.
constexpr std::array kLineColors = {kSkyBlue, kOrange, kGreen, kPurple, kVermilion};
const cv::Scalar kWhite = cv::Scalar::all(255);
const cv::Scalar kNoImage = cv::Scalar::all(160);

cv::Scalar to_scalar(Color color) {
  return {static_cast<double>(color.blue), static_cast<double>(color.green),
          static_cast<double>(color.red)};
}

/// Returns the image in colour or, if it is empty, a grey field of the size of the other image.
cv::Mat in_color(const cv::Mat& image, const cv::Size& other) {
  if (image.empty()) {
    const cv::Size size = other.empty() ? cv::Size(320, 240) : other;
    return {size, CV_8UC3, kNoImage};
  }
  if (image.channels() == 3) return image;
  cv::Mat color;
  cv::cvtColor(image, color, cv::COLOR_GRAY2BGR);
  return color;
}

cv::Mat side_by_side(const cv::Mat& a, const cv::Mat& b) {
  cv::Mat both(std::max(a.rows, b.rows), a.cols + kGap + b.cols, CV_8UC3, kWhite);
  a.copyTo(both(cv::Rect(0, 0, a.cols, a.rows)));
  b.copyTo(both(cv::Rect(a.cols + kGap, 0, b.cols, b.rows)));
  return both;
}

cv::Mat shrunk(const cv::Mat& image, double scale) {
  cv::Mat result;
  cv::resize(image, result, cv::Size(), scale, scale, cv::INTER_AREA);
  return result;
}

/// The two ends of a match on the scaled picture of both images.
struct Ends {
  cv::Point2f a;
  cv::Point2f b;
};

std::vector<Ends> ends_of(const std::vector<PixelPair>& pixels, int b_begins, double scale) {
  const auto at = [scale](float u, float v) {
    return cv::Point2f(static_cast<float>(scale * u), static_cast<float>(scale * v));
  };
  std::vector<Ends> ends;
  ends.reserve(pixels.size());
  for (const PixelPair& pair : pixels) {
    ends.push_back({at(pair.a_u, pair.a_v), at(pair.b_u + static_cast<float>(b_begins), pair.b_v)});
  }
  return ends;
}

cv::Scalar color_of(std::size_t match) {
  return to_scalar(kLineColors[match % kLineColors.size()]);
}

/// Draws transparent lines, so that a hundred of them do not hide what they join.
void draw_lines(const std::vector<Ends>& ends, cv::Mat& picture) {
  constexpr double kOpacity = 0.55;
  cv::Mat lines = picture.clone();
  for (std::size_t i = 0; i < ends.size(); ++i) {
    cv::line(lines, ends[i].a, ends[i].b, color_of(i), 1, cv::LINE_AA);
  }
  cv::addWeighted(lines, kOpacity, picture, 1 - kOpacity, 0, picture);
}

void draw_points(const std::vector<Ends>& ends, cv::Mat& picture) {
  const int radius = std::clamp(picture.cols / 300, 1, 3);  // [px]
  for (std::size_t i = 0; i < ends.size(); ++i) {
    for (const cv::Point2f& end : {ends[i].a, ends[i].b}) {
      cv::circle(picture, end, radius + 1, kWhite, cv::FILLED, cv::LINE_AA);
      cv::circle(picture, end, radius, color_of(i), cv::FILLED, cv::LINE_AA);
    }
  }
}

constexpr const char* kFolder = "loops";
constexpr int kWidth = 900;       // [px]; a file of two Kinect images is 1 MB then
constexpr int kJpegQuality = 80;  // 60 to 90 kB a picture

std::string_view verdict_of(const LoopCandidate& candidate) {
  return candidate.accepted ? "accepted" : "rejected";
}

std::string encoded(const char* format, const cv::Mat& image, const std::vector<int>& options) {
  std::vector<unsigned char> bytes;
  if (!cv::imencode(format, image, bytes, options)) {
    throw Error(fmt::format("OpenCV cannot encode {}", format));
  }
  return {bytes.begin(), bytes.end()};
}

/// Returns the indices of the candidates whose pictures are drawn.
std::vector<std::size_t> pictured(const std::vector<LoopCandidate>& candidates,
                                  LoopPictures which) {
  std::vector<std::size_t> indices;
  if (which == LoopPictures::kNone) return indices;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    if (candidates[i].kind != EdgeKind::kLoop) continue;
    if (candidates[i].accepted || which == LoopPictures::kAll) indices.push_back(i);
  }
  return indices;
}

/// Returns the indices of the candidates that the page shows.
std::set<std::size_t> chosen(const std::vector<LoopCandidate>& candidates,
                             std::vector<std::size_t> indices, std::size_t max_count) {
  std::stable_sort(indices.begin(), indices.end(), [&](std::size_t i, std::size_t j) {
    const LoopCandidate& a = candidates[i];
    const LoopCandidate& b = candidates[j];
    if (a.accepted != b.accepted) return a.accepted;
    return a.accepted && a.correction_translation > b.correction_translation;
  });
  indices.resize(std::min(indices.size(), max_count));
  return {indices.begin(), indices.end()};
}

/// Reads the colour images of pairs. The newer image of a pair is kept, because the next pair often
/// needs it again.
class ColorImages {
 public:
  ColorImages(const Dataset& data, std::vector<std::string>& notes) : data_(data), notes_(notes) {}

  cv::Mat older(std::size_t frame) { return read(frame); }

  cv::Mat newer(std::size_t frame) {
    if (newer_frame_ != frame) {
      newer_ = read(frame);
      newer_frame_ = frame;
    }
    return newer_;
  }

 private:
  cv::Mat read(std::size_t frame) {
    const RgbdFrame images = data_.read(frame);
    if (images.color.empty()) {
      notes_.push_back(fmt::format("no picture of frame {} of a loop: {}", frame, images.problem));
    }
    return images.color;
  }

  const Dataset& data_;
  std::vector<std::string>& notes_;
  std::optional<std::size_t> newer_frame_;
  cv::Mat newer_;
};

bool is_loop_picture(const std::filesystem::path& file) {
  static const std::regex pattern(R"((accepted|rejected)_\d{6,}_\d{6,}\.png)");
  return std::regex_match(file.filename().string(), pattern);
}

}  // namespace

cv::Mat draw_matches(const cv::Mat& a, const cv::Mat& b, const std::vector<PixelPair>& pixels,
                     int max_width) {
  const cv::Mat left = in_color(a, b.size());
  const cv::Mat right = in_color(b, a.size());
  cv::Mat picture = side_by_side(left, right);
  const double scale = std::min(1.0, static_cast<double>(max_width) / picture.cols);
  if (scale < 1) picture = shrunk(picture, scale);
  const auto ends = ends_of(pixels, left.cols + kGap, scale);
  draw_lines(ends, picture);
  draw_points(ends, picture);
  return picture;
}

LoopGallery write_loop_pictures(const std::filesystem::path& folder, const Dataset& data,
                                const std::vector<LoopCandidate>& candidates, LoopPictures which,
                                std::size_t max_chosen, std::vector<std::string>& notes) {
  LoopGallery gallery;
  const auto indices = pictured(candidates, which);
  if (indices.empty()) return gallery;
  make_folder(folder / kFolder);
  const auto on_page = chosen(candidates, indices, max_chosen);
  ColorImages images(data, notes);
  for (const std::size_t i : indices) {
    const LoopCandidate& c = candidates[i];
    const cv::Mat older = images.older(c.from);
    const cv::Mat newer = images.newer(c.to);
    const cv::Mat picture = draw_matches(older, newer, c.pixels, kWidth);
    const auto name = fmt::format("{}_{:06}_{:06}.png", verdict_of(c), c.from, c.to);
    write_file(folder / kFolder / name, encoded(".png", picture, {}));
    ++gallery.files;
    if (!on_page.contains(i)) continue;
    gallery.chosen.push_back(
        {c, encoded(".jpg", picture, {cv::IMWRITE_JPEG_QUALITY, kJpegQuality})});
  }
  return gallery;
}

void remove_loop_pictures(const std::filesystem::path& folder) {
  const auto loops = folder / kFolder;
  std::error_code ignored;
  // A link would lead to a folder that does not belong to the run.
  if (!std::filesystem::is_directory(std::filesystem::symlink_status(loops, ignored))) return;
  std::vector<std::filesystem::path> pictures;
  bool has_others = false;
  for (const auto& entry : std::filesystem::directory_iterator(loops, ignored)) {
    if (is_loop_picture(entry.path())) {
      pictures.push_back(entry.path());
    } else {
      has_others = true;
    }
  }
  for (const auto& picture : pictures) remove_file(picture);
  if (!has_others) remove_file(loops);
}

}  // namespace cvo_slam
