// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/io/dataset.h"

#include <utility>

#include <fmt/format.h>

#include "cvo_slam/core/error.h"
#include "cvo_slam/io/frame_reader_internal.h"
#include "cvo_slam/io/sequence_internal.h"

namespace cvo_slam {
namespace {

void note_unpaired(Sequence& sequence) {
  const auto& [color, depth] = sequence.unpaired;
  if (color + depth == 0) return;
  sequence.notes.push_back(
      fmt::format("{} colour and {} depth images have no partner and are left out", color, depth));
}

/// The frames of a Sequence, read from their files when asked for.
class SequenceDataset final : public Dataset {
 public:
  explicit SequenceDataset(Sequence sequence)
      : sequence_(std::move(sequence)), reader_(sequence_.camera, sequence_.invalid_depth) {
    note_unpaired(sequence_);
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
      reader_.read(files.color, files.depth, frame);
    } catch (const InputError& error) {
      frame.color.release();
      frame.problem = error.what();
    }
    return frame;
  }

 private:
  Sequence sequence_;
  FrameReader reader_;
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
