// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Tracking allocates nothing but keyframes once its memory has grown to what frames need.
#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <new>
#include <vector>

#include <gtest/gtest.h>

#include "cvo_slam/frontend/tracker.h"
#include "cvo_slam/tests/frontend/synthetic_frames.h"
#include "cvo_slam/tests/frontend/test_frames.h"
#include "cvo_slam/tests/frontend/tracker_test_options.h"

namespace {
std::atomic<std::size_t> allocations{0};
}  // namespace

// These replace the standard operators in the whole test program, and count the calls. They are not
// inlined, because GCC would see a malloc() met by a delete and warn.
[[gnu::noinline]] void* operator new(std::size_t size) {
  ++allocations;
  if (void* const memory = std::malloc(size == 0 ? 1 : size)) return memory;
  throw std::bad_alloc();
}
[[gnu::noinline]] void* operator new(std::size_t size, const std::nothrow_t& /*tag*/) noexcept {
  ++allocations;
  return std::malloc(size == 0 ? 1 : size);
}
[[gnu::noinline]] void operator delete(void* memory) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t /*size*/) noexcept {
  std::free(memory);
}

namespace cvo_slam {
namespace {

// A keyframe is handed out with a cloud of its own: a frame that makes or returns one allocates it.
TEST(SteadyState, AFrameBetweenKeyframesAllocatesNothing) {
  // The walk, forwards and backwards again and again.
  constexpr std::size_t kFrames = 20;
  const SyntheticFrames walk(small_camera(320, 240));
  std::vector<RgbdFrame> frames;
  for (std::size_t i = 0; i < kFrames; ++i) frames.push_back(walk.frame(i));
  Tracker tracker(walk.camera(), tracker_test_options());
  std::size_t index = 0;
  std::size_t keyframes = 0;
  std::size_t others = 0;
  std::size_t allocated = 0;  // between keyframes
  const auto round = [&] {
    for (std::size_t k = 0; k < 2 * kFrames; ++k, ++index) {
      RgbdFrame& frame = frames[k < kFrames ? k : 2 * kFrames - 1 - k];
      frame.index = index;
      frame.stamp = frame.depth_stamp =
          Timestamp::from_seconds(100 + static_cast<double>(index) / 30);
      const std::size_t before = allocations;
      const TrackedFrame tracked = tracker.track(frame);
      const std::size_t after = allocations;
      if (tracked.record.status == TrackingStatus::kLost) ADD_FAILURE() << tracked.record.reason;
      const bool is_keyframe = !tracked.record.keyframe_reason.empty();
      (is_keyframe ? keyframes : others) += 1;
      if (!is_keyframe && !tracked.record.promoted_keyframe) allocated += after - before;
    }
  };
  for (int i = 0; i < 3; ++i) round();
  // OpenCV's filters have buffers of their own, which do not come from here.
  keyframes = others = allocated = 0;
  round();
  EXPECT_EQ(allocated, 0U);
  EXPECT_GT(keyframes, 0U) << "the way from frame to keyframe was gone too";
  EXPECT_GT(others, 0U);
}

}  // namespace
}  // namespace cvo_slam
