// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cvo_slam/core/camera.h"
#include "cvo_slam/core/frame_source.h"
#include "cvo_slam/core/rgbd_frame.h"
#include "cvo_slam/core/trajectory.h"

namespace cvo_slam {

/// How a recorded sequence is read.
struct DatasetOptions {
  /// The camera to use. Empty: the camera file that the recording brings (camera.yaml, or another
  /// YAML file that read_camera() reads), else the built-in camera that a file of the recording
  /// names or that its images single out.
  std::optional<Camera> camera;
  /// Largest difference between the stamps of a colour and a depth image that make a frame [s].
  /// Cameras run at 30 Hz: at more than half of 33 ms, an image may be nearer to another partner.
  double max_stamp_difference = 0.02;
  /// A file of lines "stamp file stamp file" that pairs colour and depth images, in place of the
  /// sequence's own; its paths are relative to the folder of the sequence.
  std::optional<std::filesystem::path> associations = std::nullopt;
  /// The depth offset to use in place of the camera's (Camera::depth_offset) [s], at most a
  /// million. Images are paired by the stamps with it. If it is not 0, every colour image takes its
  /// nearest depth image, which two may share; else no image is in two frames.
  std::optional<double> depth_offset = std::nullopt;
  /// The frame rate of a recording whose images are numbered and have no stamps [Hz], from 0.01 to
  /// 1000; of no use to others. Empty: 30 Hz, or less where the camera turns by so much from image
  /// to image that it cannot be that; a note says what was assumed.
  std::optional<double> frame_rate = std::nullopt;
};

/// Numbers of images that have no partner and therefore are in no frame.
struct UnpairedImages {
  std::size_t color = 0;  ///< number of colour images
  std::size_t depth = 0;  ///< number of depth images
};

/// A recorded RGB-D sequence.
class Dataset {
 public:
  virtual ~Dataset() = default;

  /// Name of the sequence: the name of its folder.
  [[nodiscard]] virtual const std::string& name() const = 0;
  /// Name of the format that the folder was recognised as: "TUM RGB-D", "7-Scenes".
  [[nodiscard]] virtual const std::string& kind() const = 0;
  /// The camera of the frames that read() returns.
  [[nodiscard]] virtual const Camera& camera() const = 0;
  /// Why this camera is used, for people: "given by the caller", "camera.yaml in the folder of the
  /// sequence", "the recording is called 'rgbd_dataset_freiburg1_desk.bag'", ...
  [[nodiscard]] virtual const std::string& camera_origin() const = 0;
  /// Number of frames: pairs of a colour and a depth image, in ascending order of time.
  [[nodiscard]] virtual std::size_t size() const = 0;
  /// Reads frame `index` < size(). If an image is missing or broken, the frame has no images and
  /// its `problem` says why. May be called from several threads.
  [[nodiscard]] virtual RgbdFrame read(std::size_t index) const = 0;
  /// Returns the stamp of frame `index` without reading its images.
  [[nodiscard]] virtual Timestamp stamp(std::size_t index) const = 0;
  /// Returns the stamp of its depth image in the same way.
  [[nodiscard]] virtual Timestamp depth_stamp(std::size_t index) const = 0;
  /// Numbers of images without a partner.
  [[nodiscard]] virtual UnpairedImages unpaired() const = 0;
  /// Ground-truth poses of the colour camera; empty if the sequence has none.
  [[nodiscard]] virtual const std::vector<StampedPose>& reference() const = 0;
  /// What a user should know about the sequence, one line each: unpaired images, dropped
  /// duplicates, ...
  [[nodiscard]] virtual const std::vector<std::string>& notes() const = 0;
};

/// Opens a sequence in one of the formats of dataset_formats(), which is recognised by its files.
/// Throws InputError if the folder is missing, has none of these formats, has no frame, has a list
/// with a malformed line (file:line), or if its camera is not known.
///
/// A file that is cut off is recognised before it is decoded. Damage inside a whole file is found
/// by the decoder; the frame is marked in the same way, but libpng and libjpeg may then write a
/// line to stderr, which only a change of process-wide state could prevent.
[[nodiscard]] std::unique_ptr<Dataset> open_dataset(const std::filesystem::path& folder,
                                                    const DatasetOptions& options = {});

/// Returns the names and layouts of all formats that open_dataset() can open, for help texts:
/// "TUM RGB-D (rgb.txt and depth.txt, ...), 7-Scenes (...)".
[[nodiscard]] std::string dataset_formats();

/// Reads the frames of a range one after the other and decodes the next ones at the same time, each
/// on its own thread. next() returns what Dataset::read() would return, in the same order.
class FramePrefetcher final : public FrameSource {
 public:
  /// Takes the frames begin, begin + step, ... below `end` and reads `ahead` >= 1 of them at a
  /// time. `data` must outlive the object.
  FramePrefetcher(const Dataset& data, std::size_t begin, std::size_t end, std::size_t step = 1,
                  std::size_t ahead = 2);
  /// Waits for the frames that are being read.
  ~FramePrefetcher() override;

  /// Returns the next frame; nothing after the last one. Throws what Dataset::read() throws.
  [[nodiscard]] std::optional<RgbdFrame> next() override;

 private:
  class Queue;
  std::unique_ptr<Queue> queue_;
};

}  // namespace cvo_slam
