// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <cerrno>
#include <utility>

#include <fmt/format.h>
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
  std::optional<bool> is_depth_first;  // in all lines alike; empty = not known yet

  std::optional<TextLine> next_line();
  void wait_for_text();
  std::optional<FrameFiles> files_of(const TextLine& line);
  void order(FrameFiles& files);
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

/// The files that a line names; empty, with a note, if it names none: what came before is not lost
/// with it.
std::optional<FrameFiles> PipedDataset::Impl::files_of(const TextLine& line) {
  FrameFiles files;
  try {
    if (line.words.size() != 4) {
      throw InputError(kPipe, line.number, "expected 'stamp file stamp file'");
    }
    files = {parse_stamp(line, 0, kPipe), parse_stamp(line, 2, kPipe), line.words[1],
             line.words[3]};
    order(files);
    if (!frames.empty() && files.stamp <= frames.back().stamp) {
      throw InputError(kPipe, line.number,
                       "the stamp is not above that of the line before; write frames in order");
    }
  } catch (const InputError& error) {
    constexpr std::size_t kMostNotes = 10;
    if (notes.size() < kMostNotes) notes.push_back(fmt::format("left out: {}", error.what()));
    return std::nullopt;
  }
  return files;
}

/// Puts the colour image first. The two are told apart once, by a pair of which one is of depth.
void PipedDataset::Impl::order(FrameFiles& files) {
  if (!is_depth_first) {
    const bool first = is_depth_image(files.color);
    if (first != is_depth_image(files.depth)) is_depth_first = first;
  }
  if (!is_depth_first.value_or(false)) return;
  std::swap(files.color, files.depth);
  std::swap(files.stamp, files.depth_stamp);
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
  while (const auto line = impl_->next_line()) {
    if (auto files = impl_->files_of(*line)) {
      impl_->frames.push_back(std::move(*files));
      return impl_->read(impl_->frames.size() - 1);
    }
  }
  return std::nullopt;
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
