// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <cerrno>
#include <utility>

#include <poll.h>
#include <unistd.h>

#include "cvo_slam/core/error.h"
#include "cvo_slam/io/camera_check.h"
#include "cvo_slam/io/dataset/formats_internal.h"
#include "cvo_slam/io/followed_dataset.h"
#include "cvo_slam/io/image_files_internal.h"
#include "cvo_slam/io/text_internal.h"

namespace cvo_slam {
namespace {

constexpr const char* kPipe = "the pipe";  // in place of a file, for errors

Camera camera_of_pipe(const DatasetOptions& options) {
  if (options.associations) throw OptionError("the lines of a pipe are its associations already");
  if (!options.camera) {
    throw OptionError("the camera of images that come by a pipe is not known; give one (--camera)");
  }
  Camera camera = *options.camera;
  if (options.depth_offset) camera.depth_offset = options.depth_offset;
  camera.check();
  return camera;
}

}  // namespace

struct PipedDataset::Impl {
  Impl(int descriptor_in, const Camera& camera_in, std::function<bool()> stop_in)
      : descriptor(descriptor_in),
        stop(std::move(stop_in)),
        camera(camera_in),
        reader(camera_in),
        notes(camera_warnings(camera_in)) {
    for (std::string& note : notes) note.insert(0, "warning: ");
  }

  int descriptor;
  std::function<bool()> stop;
  Camera camera;
  FrameReader reader;
  std::string name = "pipe";
  std::string kind = "pairs of images from a pipe";
  std::string camera_origin = "given by the caller";
  std::vector<StampedPose> reference;
  std::vector<std::string> notes;
  std::vector<FrameFiles> frames;
  std::string text;  // that was read and not used yet
  long lines = 0;
  bool has_ended = false;
  std::optional<bool> is_depth_first;  // in all lines as in the first

  std::optional<TextLine> next_line();
  void wait_for_text();
  FrameFiles files_of(const TextLine& line);
  [[nodiscard]] RgbdFrame read(std::size_t index) const;
};

/// Reads what there is, or waits a moment.
void PipedDataset::Impl::wait_for_text() {
  constexpr int kMilliseconds = 50;
  pollfd request = {.fd = descriptor, .events = POLLIN, .revents = 0};
  if (poll(&request, 1, kMilliseconds) <= 0) return;
  std::array<char, 4096> part = {};
  const ssize_t size = ::read(descriptor, part.data(), part.size());
  if (size < 0 && (errno == EINTR || errno == EAGAIN)) return;
  if (size < 0) throw InputError(kPipe, "cannot be read");
  has_ended = size == 0;
  text.append(part.data(), static_cast<std::size_t>(size));
}

/// The next line that is neither blank nor a comment; empty at the end.
std::optional<TextLine> PipedDataset::Impl::next_line() {
  while (!(stop && stop())) {
    const std::size_t end = text.find('\n');
    if (end == std::string::npos && !has_ended) {
      wait_for_text();
      continue;
    }
    if (text.empty()) break;
    const std::string line = text.substr(0, end);
    text.erase(0, end == std::string::npos ? end : end + 1);
    ++lines;
    auto words = split_columns(line);
    if (!words.empty() && !words[0].starts_with('#')) return TextLine{lines, std::move(words)};
  }
  return std::nullopt;
}

FrameFiles PipedDataset::Impl::files_of(const TextLine& line) {
  if (line.words.size() != 4) {
    throw InputError(kPipe, line.number, "expected 'stamp file stamp file'");
  }
  FrameFiles files = {parse_stamp(line, 0, kPipe), parse_stamp(line, 2, kPipe), line.words[1],
                      line.words[3]};
  if (!is_depth_first) is_depth_first = is_depth_image(files.color) && !is_depth_image(files.depth);
  if (*is_depth_first) {
    std::swap(files.color, files.depth);
    std::swap(files.stamp, files.depth_stamp);
  }
  if (!frames.empty() && files.stamp <= frames.back().stamp) {
    throw InputError(kPipe, line.number,
                     "the stamp is not above that of the line before; write frames in their order");
  }
  return files;
}

RgbdFrame PipedDataset::Impl::read(std::size_t index) const {
  const FrameFiles& files = frames.at(index);
  RgbdFrame frame;
  try {
    frame = reader.read(files.color, files.depth);
  } catch (const InputError& error) {
    frame.problem = error.what();
  }
  frame.index = index;
  frame.stamp = files.stamp;
  frame.depth_stamp = files.depth_stamp;
  return frame;
}

PipedDataset::PipedDataset(int descriptor, const DatasetOptions& options,
                           std::function<bool()> stop)
    : impl_(std::make_unique<Impl>(descriptor, camera_of_pipe(options), std::move(stop))) {}

PipedDataset::~PipedDataset() = default;

std::optional<RgbdFrame> PipedDataset::next() {
  const auto line = impl_->next_line();
  if (!line) return std::nullopt;
  impl_->frames.push_back(impl_->files_of(*line));
  return impl_->read(impl_->frames.size() - 1);
}

const std::string& PipedDataset::name() const { return impl_->name; }
const std::string& PipedDataset::kind() const { return impl_->kind; }
const Camera& PipedDataset::camera() const { return impl_->camera; }
const std::string& PipedDataset::camera_origin() const { return impl_->camera_origin; }
std::size_t PipedDataset::size() const { return impl_->frames.size(); }
RgbdFrame PipedDataset::read(std::size_t index) const { return impl_->read(index); }
Timestamp PipedDataset::stamp(std::size_t index) const { return impl_->frames.at(index).stamp; }
Timestamp PipedDataset::depth_stamp(std::size_t index) const {
  return impl_->frames.at(index).depth_stamp;
}
const std::vector<StampedPose>& PipedDataset::reference() const { return impl_->reference; }
const std::vector<std::string>& PipedDataset::notes() const { return impl_->notes; }

}  // namespace cvo_slam
