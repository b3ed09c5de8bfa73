// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Google Highway compiles this file once for each instruction set and picks one at run time. The
// list of sets is that of the tracker (frontend/pair_sums.cc), so that a set chosen there is chosen
// here as well.
#define HWY_DISABLED_TARGETS \
  (HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV | HWY_SSSE3 | HWY_AVX3_DL)
#define HWY_COMPILE_ALL_ATTAINABLE
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "cvo_slam/loop/hamming.cc"
#include <hwy/foreach_target.h>  // must come before highway.h
#include <hwy/highway.h>

#include "cvo_slam/loop/descriptor.h"

HWY_BEFORE_NAMESPACE();
namespace cvo_slam::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

/// A descriptor is one vector of 256 bits, or two or four narrower ones.
using Tag = hn::CappedTag<std::uint64_t, 4>;
using Words = hn::Vec<Tag>;
constexpr Tag kTag;
constexpr std::size_t kLanes = hn::MaxLanes(Tag());
constexpr std::size_t kVectors = 4 / kLanes;

struct Query {
  explicit Query(const Descriptor& descriptor) {
    for (std::size_t i = 0; i < kVectors; ++i) {
      parts[i] = hn::LoadU(kTag, descriptor.words.data() + i * kLanes);
    }
  }

  [[nodiscard]] HWY_INLINE int distance(const Descriptor& other) const {
    Words count = hn::Zero(kTag);
    for (std::size_t i = 0; i < kVectors; ++i) {
      const Words word = hn::LoadU(kTag, other.words.data() + i * kLanes);
      count = hn::Add(count, hn::PopulationCount(hn::Xor(parts[i], word)));
    }
    return static_cast<int>(hn::GetLane(hn::SumOfLanes(kTag, count)));
  }

  Words parts[kVectors];  // NOLINT(modernize-avoid-c-arrays): vectors may not be in a std::array
};

void all_distances(const Descriptor& query, const Descriptor* candidates, std::size_t count,
                   std::uint16_t* distances) {
  const Query q(query);
  for (std::size_t i = 0; i < count; ++i) {
    distances[i] = static_cast<std::uint16_t>(q.distance(candidates[i]));
  }
}

NearestDescriptor nearest(const Descriptor& query, const Descriptor* candidates,
                          std::size_t count) {
  const Query q(query);
  NearestDescriptor best;
  for (std::size_t i = 0; i < count; ++i) {
    const int distance = q.distance(candidates[i]);
    if (distance < best.distance) best = {i, distance};
  }
  return best;
}

}  // namespace
}  // namespace cvo_slam::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace cvo_slam {

HWY_EXPORT(all_distances);
HWY_EXPORT(nearest);

void hamming_distances(const Descriptor& query, std::span<const Descriptor> candidates,
                       std::span<std::uint16_t> distances) {
  HWY_DYNAMIC_DISPATCH(all_distances)
  (query, candidates.data(), candidates.size(), distances.data());
}

NearestDescriptor nearest_descriptor(const Descriptor& query,
                                     std::span<const Descriptor> candidates) {
  return HWY_DYNAMIC_DISPATCH(nearest)(query, candidates.data(), candidates.size());
}

}  // namespace cvo_slam
#endif
