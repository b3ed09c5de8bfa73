// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cvo_slam/io/dataset.h"

namespace cvo_slam {

/// When a recording that is being written counts as ended.
struct FollowOptions {
  /// A recording at which nothing has changed for so long has ended [s], above 0, at most a
  /// million.
  double end_after = 10;
  /// Asked about twenty times a second while waiting; true ends the recording at once. May be
  /// empty.
  std::function<bool()> stop = {};
};

/// A recording that is still being written: next() waits for frames and returns them as they
/// appear. As a Dataset it holds the frames that next() has returned.
///
///     FollowedDataset frames(folder);
///     while (const auto frame = frames.next()) slam.track(*frame);
///
/// A frame is returned when there are images so much later that none can be paired otherwise any
/// more (a tenth of a second), the last ones when the recording has ended. Images that cannot be
/// read are tried again for a second. A frame that appears after one with a later stamp is left
/// out, with a note. next() is for one thread at a time, while no other function runs; it ends the
/// life of references that the others returned, except camera().
class FollowedDataset final : public Dataset, public FrameSource {
 public:
  /// Waits for a folder that open_dataset() can open. Throws what that throws if there is none
  /// after FollowOptions::end_after, or when it is told to stop, and OptionError.
  explicit FollowedDataset(std::filesystem::path folder, DatasetOptions options = {},
                           FollowOptions follow = {});
  ~FollowedDataset() override;

  [[nodiscard]] std::optional<RgbdFrame> next() override;

  [[nodiscard]] const std::string& name() const override { return newest_->name(); }
  [[nodiscard]] const std::string& kind() const override { return newest_->kind(); }
  [[nodiscard]] const Camera& camera() const override { return *options_.camera; }
  [[nodiscard]] const std::string& camera_origin() const override { return camera_origin_; }
  [[nodiscard]] std::size_t size() const override { return stamps_.size(); }
  [[nodiscard]] RgbdFrame read(std::size_t index) const override;
  [[nodiscard]] Timestamp stamp(std::size_t index) const override { return stamps_.at(index); }
  [[nodiscard]] Timestamp depth_stamp(std::size_t index) const override;
  [[nodiscard]] UnpairedImages unpaired() const override { return newest_->unpaired(); }
  [[nodiscard]] const std::vector<StampedPose>& reference() const override {
    return newest_->reference();
  }
  [[nodiscard]] const std::vector<std::string>& notes() const override { return notes_; }

 private:
  class FolderWatch;
  using Clock = std::chrono::steady_clock;

  [[nodiscard]] bool is_stopped() const { return follow_.stop && follow_.stop(); }
  [[nodiscard]] bool has_ended() const;
  /// Looks at the folder, and opens it again if something has changed.
  void refresh();
  void reopen();
  void take_over(std::unique_ptr<Dataset> data);
  /// Adds a note that is not there yet.
  void note(const std::string& text);
  [[nodiscard]] bool is_settled(std::size_t position) const;
  /// Returns the position in newest_ of its first frame after those that were returned.
  [[nodiscard]] std::size_t next_position() const;
  /// Returns the position in newest_ of a frame that was returned.
  [[nodiscard]] std::size_t position_of(std::size_t index) const;

  std::filesystem::path folder_;
  DatasetOptions options_;
  FollowOptions follow_;
  std::unique_ptr<FolderWatch> watch_;
  std::unique_ptr<Dataset> newest_;  // the recording as far as it was written
  std::vector<Timestamp> newest_stamps_;
  std::string camera_origin_;
  std::vector<Timestamp> stamps_;  // of the frames returned
  std::vector<std::string> notes_;
  std::string state_;        // of the folder when it was looked at last
  bool is_current_ = false;  // newest_ is of that state
  Clock::time_point last_change_ = Clock::now();
  Clock::time_point next_opening_;
  std::optional<Clock::time_point> first_try_;  // to read the next frame
};

/// Frames whose images are named on a pipe, a line each: "stamp file stamp file", the colour image
/// first or the depth image, as in associations.txt. next() waits for a line, and returns its
/// frame. As a Dataset it holds the frames that next() has returned, as long as their files are
/// there.
///
///     recorder | program        # 12.033 /data/7.png 12.031 /data/7_depth.png
class PipedDataset final : public Dataset, public FrameSource {
 public:
  /// Reads lines from a file descriptor, 0 for standard input, which is not closed. `stop` is asked
  /// about twenty times a second while waiting; true ends the sequence at once. Throws OptionError
  /// if the options give no camera, or associations.
  PipedDataset(int descriptor, const DatasetOptions& options, std::function<bool()> stop = {});
  ~PipedDataset() override;

  /// A line that is none, or has a stamp that is not above the one before, is left out, with a
  /// note. Throws InputError if the pipe cannot be read.
  [[nodiscard]] std::optional<RgbdFrame> next() override;

  [[nodiscard]] const std::string& name() const override;
  [[nodiscard]] const std::string& kind() const override;
  [[nodiscard]] const Camera& camera() const override;
  [[nodiscard]] const std::string& camera_origin() const override;
  [[nodiscard]] std::size_t size() const override;
  [[nodiscard]] RgbdFrame read(std::size_t index) const override;
  [[nodiscard]] Timestamp stamp(std::size_t index) const override;
  [[nodiscard]] Timestamp depth_stamp(std::size_t index) const override;
  [[nodiscard]] UnpairedImages unpaired() const override { return {}; }
  [[nodiscard]] const std::vector<StampedPose>& reference() const override;
  [[nodiscard]] const std::vector<std::string>& notes() const override;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace cvo_slam
