// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/io/dataset.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <future>
#include <utility>

#include <fmt/format.h>

#include "cvo_slam/core/error.h"
#include "cvo_slam/io/camera_check.h"
#include "cvo_slam/io/dataset/camera_choice_internal.h"
#include "cvo_slam/io/dataset/formats_internal.h"
#include "cvo_slam/io/dataset/frame_rate_internal.h"
#include "cvo_slam/io/image_files_internal.h"

namespace cvo_slam {
namespace {

using Path = std::filesystem::path;

constexpr double kMostSeconds = 1e6;  // what nanoseconds in 64 bits can add to any stamp

const DatasetFormat& recognise_format(const Path& folder, const DatasetOptions& options) {
  if (options.associations) return kTumFormat;  // its folder needs no list
  const auto formats = all_dataset_formats();
  const auto found = std::find_if(formats.begin(), formats.end(), [&](const DatasetFormat* format) {
    return format->recognise(folder);
  });
  if (found != formats.end()) return **found;
  throw InputError(folder, fmt::format("is no known data set; the folder of a sequence holds the "
                                       "files of one of these: {}",
                                       dataset_formats()));
}

/// Returns what choose_camera() does. Throws CameraError.
ChosenCamera known_camera(const Path& folder, const DatasetOptions& options,
                          const DatasetFormat& format, const Sequence& sequence) {
  try {
    return choose_camera(folder, options.camera, format, sequence);
  } catch (const InputError& error) {
    throw CameraError(error);
  }
}

/// Reads the frames of a Sequence from their files when asked for.
class SequenceDataset final : public Dataset {
 public:
  SequenceDataset(const Path& folder, const DatasetFormat& format, ChosenCamera camera,
                  Sequence sequence)
      : name_(folder_name(folder)),
        kind_(format.name),
        camera_(std::move(camera)),
        sequence_(std::move(sequence)),
        reader_(camera_.camera, sequence_.invalid_depth) {
    sequence_.reference = reference_of(sequence_, camera_.camera);
    for (const std::string& warning : camera_warnings(camera_.camera)) {
      sequence_.notes.push_back("warning: " + warning);
    }
    const auto& [color, depth] = sequence_.unpaired;
    if (color + depth == 0) return;
    sequence_.notes.push_back(fmt::format(
        "{} colour and {} depth images have no partner and are left out", color, depth));
  }

  [[nodiscard]] const std::string& name() const override { return name_; }
  [[nodiscard]] const std::string& kind() const override { return kind_; }
  [[nodiscard]] const Camera& camera() const override { return camera_.camera; }
  [[nodiscard]] const std::string& camera_origin() const override { return camera_.origin; }
  [[nodiscard]] std::size_t size() const override { return sequence_.frames.size(); }
  [[nodiscard]] Timestamp stamp(std::size_t index) const override {
    return sequence_.frames.at(index).stamp;
  }
  [[nodiscard]] Timestamp depth_stamp(std::size_t index) const override {
    return sequence_.frames.at(index).depth_stamp;
  }
  [[nodiscard]] UnpairedImages unpaired() const override { return sequence_.unpaired; }
  [[nodiscard]] const std::vector<StampedPose>& reference() const override {
    return sequence_.reference;
  }
  [[nodiscard]] const std::vector<std::string>& notes() const override { return sequence_.notes; }

  [[nodiscard]] RgbdFrame read(std::size_t index) const override {
    const FrameFiles& files = sequence_.frames.at(index);
    RgbdFrame frame = read_images(files);
    frame.index = index;
    frame.stamp = files.stamp;
    frame.depth_stamp = files.depth_stamp;
    return frame;
  }

 private:
  [[nodiscard]] RgbdFrame read_images(const FrameFiles& files) const {
    try {
      return reader_.read(files.color, files.depth);
    } catch (const InputError& error) {
      RgbdFrame frame;
      frame.problem = error.what();
      return frame;
    }
  }

  std::string name_;
  std::string kind_;
  ChosenCamera camera_;
  Sequence sequence_;
  FrameReader reader_;
};

}  // namespace

std::unique_ptr<Dataset> open_dataset(const Path& folder, const DatasetOptions& options) {
  if (!std::filesystem::exists(folder)) throw InputError(folder, "no such folder; check the path");
  if (!std::filesystem::is_directory(folder)) {
    throw InputError(folder, "is not a folder; give the folder of a sequence");
  }
  if (!(options.max_stamp_difference >= 0 && options.max_stamp_difference <= kMostSeconds)) {
    throw OptionError("max_stamp_difference must be from 0 to a million seconds");
  }
  if (!(std::fabs(options.depth_offset.value_or(0)) <= kMostSeconds)) {
    throw OptionError("depth_offset must be at most a million seconds");
  }
  if (!(options.frame_rate.value_or(1) >= 0.01 && options.frame_rate.value_or(1) <= 1000)) {
    throw OptionError("frame_rate must be from 0.01 to 1000 Hz");
  }
  const DatasetFormat& format = recognise_format(folder, options);
  PairingOptions pairing = {options.associations, options.max_stamp_difference,
                            options.depth_offset.value_or(0)};
  pairing.frame_rate = options.frame_rate.value_or(pairing.frame_rate);
  Sequence sequence = format.open(folder, pairing);
  ChosenCamera camera = known_camera(folder, options, format, sequence);
  if (options.depth_offset) camera.camera.depth_offset = options.depth_offset;
  std::optional<LikelyFrameRate> likely;
  if (sequence.has_counted_stamps && !options.frame_rate) {
    likely = likely_frame_rate(sequence, camera.camera, pairing.frame_rate);
  }
  const double depth_offset = camera.camera.depth_offset.value_or(0);
  if (depth_offset != pairing.depth_offset || likely) {
    pairing.depth_offset = depth_offset;  // the camera's own
    if (likely) pairing.frame_rate = likely->rate;
    sequence = format.open(folder, pairing);
    if (likely) sequence.notes.push_back(likely->note);
  }
  return std::make_unique<SequenceDataset>(folder, format, std::move(camera), std::move(sequence));
}

/// The frames that are being read, in order.
class FramePrefetcher::Queue {
 public:
  Queue(const Dataset& data, std::size_t begin, std::size_t end, std::size_t step)
      : data_(data), next_(begin), end_(end), step_(step) {}

  [[nodiscard]] bool empty() const { return frames_.empty(); }

  /// Starts to read one more frame of the range, if there is one.
  void push() {
    if (next_ >= end_) return;
    frames_.push_back(
        std::async(std::launch::async, [this, index = next_] { return data_.read(index); }));
    next_ = step_ < end_ - next_ ? next_ + step_ : end_;
  }

  std::future<RgbdFrame> pop() {
    std::future<RgbdFrame> frame = std::move(frames_.front());
    frames_.pop_front();
    return frame;
  }

 private:
  const Dataset& data_;
  std::size_t next_;
  std::size_t end_;
  std::size_t step_;
  std::deque<std::future<RgbdFrame>> frames_;  // their destructors wait for the threads
};

FramePrefetcher::FramePrefetcher(const Dataset& data, std::size_t begin, std::size_t end,
                                 std::size_t step, std::size_t ahead)
    : queue_(std::make_unique<Queue>(data, begin, end, step)) {
  for (std::size_t i = 0; i < ahead; ++i) queue_->push();
}

FramePrefetcher::~FramePrefetcher() = default;

std::optional<RgbdFrame> FramePrefetcher::next() {
  if (queue_->empty()) return std::nullopt;
  std::future<RgbdFrame> frame = queue_->pop();
  queue_->push();
  return frame.get();
}

}  // namespace cvo_slam
