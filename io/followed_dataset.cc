// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/io/followed_dataset.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <system_error>
#include <utility>

#include <fmt/format.h>
#include <poll.h>
#include <sys/inotify.h>
#include <unistd.h>

#include "cvo_slam/core/error.h"
#include "cvo_slam/io/dataset/camera_choice_internal.h"
#include "cvo_slam/io/dataset/formats_internal.h"

namespace cvo_slam {
namespace {

namespace fs = std::filesystem;

constexpr std::chrono::milliseconds kLongestWait(50);  // file systems of a network tell nothing
constexpr std::chrono::seconds kPatience(1);           // with images that cannot be read
constexpr int kShareOfOpening = 10;  // opening takes at most one in so many seconds

/// Returns true for lists of images, which grow; the poses of 7-Scenes are files of one frame each.
bool is_list(const fs::path& file) {
  return (file.extension() == ".txt" && file.stem().extension() != ".pose") ||
         file.extension() == ".csv";
}

/// Returns a text that is another one when a file was added to the folder or to one below it, or a
/// list has grown: one in the folder, or the one that pairs the images.
std::string state_of(const fs::path& folder, const std::optional<fs::path>& associations) {
  std::error_code error;
  const auto time_of = [&](const fs::path& path) {
    return fs::last_write_time(path, error).time_since_epoch().count();
  };
  std::string state = fmt::format("{}", time_of(folder));
  if (associations) state += fmt::format(",{}", fs::file_size(*associations, error));
  error.clear();
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error)) {
    std::error_code ignored;
    if (entry->is_directory(ignored)) {
      state += fmt::format("/{}", time_of(entry->path()));
    } else if (is_list(entry->path())) {
      state += fmt::format(",{}", entry->file_size(ignored));
    }
  }
  return state;
}

}  // namespace

/// Waits for changes of the files in a folder and in those below it.
class FollowedDataset::FolderWatch {
 public:
  FolderWatch() : events_(inotify_init1(IN_NONBLOCK | IN_CLOEXEC)) {}
  ~FolderWatch() {
    if (events_ >= 0) close(events_);
  }
  FolderWatch(const FolderWatch&) = delete;
  FolderWatch& operator=(const FolderWatch&) = delete;

  /// Begins to watch a folder and those below it that are not watched yet.
  void add(const fs::path& folder) const {
    add_one(folder);
    std::error_code error;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
         entry.increment(error)) {
      std::error_code ignored;
      if (entry->is_directory(ignored)) add_one(entry->path());
    }
  }
  /// Returns after a change, or after a while.
  void wait() const {
    pollfd events{events_, POLLIN, 0};
    static_cast<void>(poll(&events, 1, static_cast<int>(kLongestWait.count())));
    std::array<std::byte, 4096> text{};
    while (::read(events_, text.data(), text.size()) > 0) continue;
  }

 private:
  void add_one(const fs::path& folder) const {
    // A line that is added to a list that stays open is seen at the next look.
    constexpr std::uint32_t kChanges = IN_CREATE | IN_MOVED_TO | IN_CLOSE_WRITE;
    static_cast<void>(inotify_add_watch(events_, folder.c_str(), kChanges));
  }

  int events_;
};

FollowedDataset::FollowedDataset(fs::path folder, DatasetOptions options, FollowOptions follow)
    : folder_(std::move(folder)),
      options_(std::move(options)),
      follow_(std::move(follow)),
      watch_(std::make_unique<FolderWatch>()) {
  // One rate for the whole recording, of which there is nothing yet to guess it from.
  options_.frame_rate = options_.frame_rate.value_or(PairingOptions().frame_rate);
  constexpr double kMostSeconds = 1e6;
  if (!(follow_.end_after > 0 && follow_.end_after <= kMostSeconds)) {
    throw OptionError("end_after must be above 0 and at most a million seconds");
  }
  while (true) {
    try {
      refresh();
      if (newest_) break;
    } catch (const CameraError&) {
      // Its file may come a moment after the images, but not in an hour.
      if (!first_try_) first_try_ = Clock::now();
      if (Clock::now() - *first_try_ >= kPatience || has_ended() || is_stopped()) throw;
    } catch (const InputError&) {
      if (has_ended() || is_stopped()) throw;
    }
    watch_->wait();
  }
  first_try_.reset();
  camera_origin_ = newest_->camera_origin();
  options_.camera = newest_->camera();  // found once; the images need not be asked again
}

FollowedDataset::~FollowedDataset() = default;

std::optional<RgbdFrame> FollowedDataset::next() {
  while (!is_stopped()) {
    refresh();
    const bool ended = has_ended();
    // Files that came within a tick of the clock of file times after the last look were not seen.
    if (ended && next_position() + 1 >= newest_->size()) reopen();
    const std::size_t position = next_position();
    if (position < newest_->size() && (ended || is_settled(position))) {
      RgbdFrame frame = newest_->read(position);
      const auto now = Clock::now();
      if (!first_try_) first_try_ = now;
      if (frame.problem.empty() || now - *first_try_ >= kPatience) {
        first_try_.reset();
        frame.index = stamps_.size();
        stamps_.push_back(frame.stamp);
        return frame;
      }
    } else if (ended) {
      break;
    }
    watch_->wait();
  }
  const std::size_t late = next_position() - std::min(next_position(), stamps_.size());
  if (late > 0) {
    note(fmt::format("{} frames appeared after frames with later stamps and are left out", late));
  }
  return std::nullopt;
}

RgbdFrame FollowedDataset::read(std::size_t index) const {
  RgbdFrame frame = newest_->read(position_of(index));
  frame.index = index;
  return frame;
}

Timestamp FollowedDataset::depth_stamp(std::size_t index) const {
  return newest_->depth_stamp(position_of(index));
}

bool FollowedDataset::has_ended() const {
  return Clock::now() - last_change_ >= std::chrono::duration<double>(follow_.end_after);
}

void FollowedDataset::refresh() {
  std::string state = state_of(folder_, options_.associations);
  if (state != state_) {
    state_ = std::move(state);
    last_change_ = Clock::now();
    watch_->add(folder_);
    is_current_ = false;
  }
  if (!is_current_ && Clock::now() >= next_opening_) reopen();
}

/// Opens the folder again. A list may end within a line just now, so that the recording stays as it
/// was if it cannot be opened; throws InputError if it never could.
void FollowedDataset::reopen() {
  const auto start = Clock::now();
  try {
    take_over(open_dataset(folder_, options_));
    is_current_ = true;
  } catch (const InputError& error) {
    if (!newest_) throw;
    if (has_ended()) note(fmt::format("the last files could not be read: {}", error.what()));
  }
  next_opening_ = Clock::now() + kShareOfOpening * (Clock::now() - start);
}

/// Replaces the newest opening, unless the folder has got another layout since frames were
/// returned.
void FollowedDataset::take_over(std::unique_ptr<Dataset> data) {
  if (!stamps_.empty() && data->kind() != newest_->kind()) {
    note(fmt::format(
        "the folder looks like {} now, and like {} when its first frame was read: it is "
        "followed as that",
        data->kind(), newest_->kind()));
    return;
  }
  newest_ = std::move(data);
  notes_ = newest_->notes();
  newest_stamps_.resize(newest_->size());
  for (std::size_t i = 0; i < newest_->size(); ++i) newest_stamps_[i] = newest_->stamp(i);
}

void FollowedDataset::note(const std::string& text) {
  if (std::find(notes_.begin(), notes_.end(), text) == notes_.end()) notes_.push_back(text);
}

/// Returns true if no later image can take a partner of the frame away: each may be as far from it
/// as a partner may be, and so on.
bool FollowedDataset::is_settled(std::size_t position) const {
  constexpr double kLinks = 4;
  return seconds_between(newest_stamps_[position], newest_stamps_.back()) >
         kLinks * options_.max_stamp_difference;
}

std::size_t FollowedDataset::next_position() const {
  if (stamps_.empty()) return 0;
  const auto next = std::upper_bound(newest_stamps_.begin(), newest_stamps_.end(), stamps_.back());
  return static_cast<std::size_t>(next - newest_stamps_.begin());
}

std::size_t FollowedDataset::position_of(std::size_t index) const {
  const auto found =
      std::lower_bound(newest_stamps_.begin(), newest_stamps_.end(), stamps_.at(index));
  return static_cast<std::size_t>(found - newest_stamps_.begin());
}

}  // namespace cvo_slam
