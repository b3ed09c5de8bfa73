// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/io/followed_dataset.h"

#include <algorithm>
#include <ranges>
#include <system_error>
#include <thread>
#include <utility>

#include <fmt/format.h>

#include "cvo_slam/core/error.h"

namespace cvo_slam {
namespace {

namespace fs = std::filesystem;

constexpr std::chrono::milliseconds kPause(50);
constexpr std::chrono::seconds kPatience(1);  // with images that cannot be read
constexpr int kShareOfOpening = 10;           // opening takes at most one in so many seconds

bool is_list(const fs::path& file) {
  return file.extension() == ".txt" || file.extension() == ".csv";
}

/// Returns a text that is another one when a file was added to the folder or to one below it, or a
/// list there has grown.
std::string state_of(const fs::path& folder) {
  std::error_code error;
  const auto time_of = [&](const fs::path& path) {
    return fs::last_write_time(path, error).time_since_epoch().count();
  };
  std::string state = fmt::format("{}", time_of(folder));
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

FollowedDataset::FollowedDataset(fs::path folder, DatasetOptions options, FollowOptions follow)
    : folder_(std::move(folder)), options_(std::move(options)), follow_(std::move(follow)) {
  constexpr double kMostSeconds = 1e6;
  if (!(follow_.end_after > 0 && follow_.end_after <= kMostSeconds)) {
    throw OptionError("end_after must be above 0 and at most a million seconds");
  }
  while (true) {
    try {
      refresh();
      if (newest_) break;
    } catch (const InputError&) {
      if (has_ended() || is_stopped()) throw;
    }
    std::this_thread::sleep_for(kPause);
  }
  camera_origin_ = newest_->camera_origin();
  options_.camera = newest_->camera();  // found once; the images need not be asked again
}

std::optional<RgbdFrame> FollowedDataset::next() {
  while (!is_stopped()) {
    refresh();
    bool ended = has_ended();
    if (ended && next_position() + 1 >= newest_->size()) {
      // Files that came within a tick of the clock of file times after the last look were not seen.
      reopen();
      ended = has_ended();
    }
    const std::size_t position = next_position();
    if (position < newest_->size() && (position + 1 < newest_->size() || ended)) {
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
    std::this_thread::sleep_for(kPause);
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
  std::string state = state_of(folder_);
  if (state != state_) {
    state_ = std::move(state);
    last_change_ = Clock::now();
    is_current_ = false;
  }
  if (!is_current_ && Clock::now() >= next_opening_) reopen();
}

/// Opens the folder again. A list may end within a line just now, so that the recording stays as it
/// was if it cannot be opened; throws InputError if it never could.
void FollowedDataset::reopen() {
  const auto start = Clock::now();
  try {
    newest_ = open_dataset(folder_, options_);
    notes_ = newest_->notes();
    is_current_ = true;
  } catch (const InputError& error) {
    if (!newest_) throw;
    if (has_ended()) note(fmt::format("the last files could not be read: {}", error.what()));
  }
  next_opening_ = Clock::now() + kShareOfOpening * (Clock::now() - start);
}

void FollowedDataset::note(const std::string& text) {
  if (std::find(notes_.begin(), notes_.end(), text) == notes_.end()) notes_.push_back(text);
}

std::size_t FollowedDataset::next_position() const {
  return stamps_.empty() ? 0 : position_of(stamps_.size() - 1) + 1;
}

std::size_t FollowedDataset::position_of(std::size_t index) const {
  const auto positions = std::views::iota(std::size_t{0}, newest_->size());
  const auto found =
      std::ranges::lower_bound(positions, stamps_.at(index), {},
                               [this](std::size_t position) { return newest_->stamp(position); });
  return static_cast<std::size_t>(found - positions.begin());
}

}  // namespace cvo_slam
