// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/io/dataset.h"

#include <optional>
#include <utility>

#include <fmt/format.h>
#include <opencv2/core.hpp>

#include "cvo_slam/core/error.h"
#include "cvo_slam/io/depth_registration.h"
#include "cvo_slam/io/image_file_internal.h"
#include "cvo_slam/io/sequence_internal.h"

namespace cvo_slam {
namespace {

cv::Size image_size(const PinholeCamera& camera) { return {camera.width, camera.height}; }

void note_unpaired(Sequence& sequence) {
  const auto& [color, depth] = sequence.unpaired;
  if (color + depth == 0) return;
  sequence.notes.push_back(
      fmt::format("{} colour and {} depth images have no partner and are left out", color, depth));
}

/// The frames of a Sequence, read from their files when asked for.
class SequenceDataset final : public Dataset {
 public:
  explicit SequenceDataset(Sequence sequence) : sequence_(std::move(sequence)) {
    note_unpaired(sequence_);
    if (sequence_.camera.depth) registration_.emplace(sequence_.camera);
  }

  [[nodiscard]] const std::string& name() const override { return sequence_.name; }
  [[nodiscard]] const std::string& kind() const override { return sequence_.kind; }
  [[nodiscard]] const Camera& camera() const override { return sequence_.camera; }
  [[nodiscard]] std::size_t size() const override { return sequence_.frames.size(); }
  [[nodiscard]] Timestamp stamp(std::size_t index) const override {
    return sequence_.frames.at(index).stamp;
  }
  [[nodiscard]] UnpairedImages unpaired() const override { return sequence_.unpaired; }
  [[nodiscard]] const std::vector<StampedPose>& reference() const override {
    return sequence_.reference;
  }
  [[nodiscard]] const std::vector<std::string>& notes() const override { return sequence_.notes; }

  [[nodiscard]] RgbdFrame read(std::size_t index) const override {
    const FrameFiles& files = sequence_.frames.at(index);
    RgbdFrame frame;
    frame.index = index;
    frame.stamp = files.stamp;
    frame.depth_stamp = files.depth_stamp;
    try {
      frame.color = read_color_image(files.color, image_size(sequence_.camera.color));
      frame.depth = read_depth(files.depth);
    } catch (const InputError& error) {
      frame.color.release();
      frame.problem = error.what();
    }
    return frame;
  }

 private:
  [[nodiscard]] cv::Mat read_depth(const std::filesystem::path& file) const {
    const Camera& camera = sequence_.camera;
    const PinholeCamera& pinhole = camera.depth ? camera.depth->pinhole : camera.color;
    cv::Mat depth = read_depth_image(file, image_size(pinhole));
    if (sequence_.invalid_depth != 0) depth.setTo(0, depth == sequence_.invalid_depth);
    if (registration_) depth = registration_->to_color(depth);
    if (cv::countNonZero(depth) == 0) throw InputError(file, "the depth image has no valid pixel");
    return depth;
  }

  Sequence sequence_;
  std::optional<DepthRegistration> registration_;
};

Sequence open_sequence(const std::filesystem::path& folder, const DatasetOptions& options) {
  if (is_tum_folder(folder)) return open_tum_sequence(folder, options);
  if (is_seven_scenes_folder(folder)) return open_seven_scenes_sequence(folder, options);
  throw InputError(folder,
                   "is no known data set: expected rgb.txt and depth.txt, or associations.txt "
                   "(TUM RGB-D, ICL-NUIM), or frame-000000.color.png (7-Scenes)");
}

}  // namespace

std::string folder_name(const std::filesystem::path& folder) {
  return std::filesystem::canonical(folder).filename().string();
}

std::unique_ptr<Dataset> open_dataset(const std::filesystem::path& folder,
                                      const DatasetOptions& options) {
  if (!std::filesystem::exists(folder)) throw InputError(folder, "no such folder; check the path");
  if (!std::filesystem::is_directory(folder)) {
    throw InputError(folder, "is not a folder; give the folder of a sequence");
  }
  if (!(options.max_stamp_difference >= 0)) {
    throw OptionError("max_stamp_difference must be 0 or more seconds");
  }
  return std::make_unique<SequenceDataset>(open_sequence(folder, options));
}

}  // namespace cvo_slam
