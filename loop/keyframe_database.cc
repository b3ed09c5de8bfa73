// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <numeric>

#include <fmt/format.h>

#include "cvo_slam/core/error.h"
#include "cvo_slam/loop/candidate_groups_internal.h"
#include "cvo_slam/loop/loop_detector.h"

namespace cvo_slam {

KeyframeDatabase::KeyframeDatabase(std::size_t words) : entries_(words) {}

void KeyframeDatabase::add(const BagOfWords& bag) {
  if (!bag.empty() && bag.back().word >= entries_.size()) {
    throw DataError(
        fmt::format("keyframe with the word {}: the vocabulary has {}; use the one that made it",
                    bag.back().word, entries_.size()));
  }
  const auto position = static_cast<std::uint32_t>(size());
  for (const WordWeight& word : bag) entries_[word.word].push_back({position, word.weight});
  sums_.emplace_back();
}

void KeyframeDatabase::remove(std::size_t position, const BagOfWords& bag) {
  for (const WordWeight& word : bag) {
    std::vector<Entry>& entries = entries_[word.word];
    std::erase_if(entries, [position](const Entry& entry) { return entry.position == position; });
    // Or words that were seen once would keep their memory for good.
    if (2 * entries.size() < entries.capacity()) entries.shrink_to_fit();
  }
}

std::vector<KeyframeMatch> KeyframeDatabase::query(const BagOfWords& bag, std::size_t end) {
  std::vector<std::uint32_t> touched;
  for (const WordWeight& word : bag) {
    if (word.word >= entries_.size()) continue;
    for (const Entry& entry : entries_[word.word]) {
      if (entry.position >= end) break;
      Sum& sum = sums_[entry.position];
      if (sum.shared_words++ == 0) touched.push_back(entry.position);
      sum.score += std::min(word.weight, entry.weight);
    }
  }
  std::sort(touched.begin(), touched.end());
  std::vector<KeyframeMatch> matches;
  matches.reserve(touched.size());
  for (const std::uint32_t position : touched) {
    matches.push_back({position, sums_[position].score, sums_[position].shared_words});
    sums_[position] = Sum();
  }
  return matches;
}

std::size_t KeyframeDatabase::bytes() const {
  return std::accumulate(entries_.begin(), entries_.end(),
                         entries_.size() * sizeof(std::vector<Entry>) + sums_.size() * sizeof(Sum),
                         [](std::size_t sum, const std::vector<Entry>& entries) {
                           return sum + entries.size() * sizeof(Entry);
                         });
}

std::vector<CandidateGroup> group_candidates(const std::vector<KeyframeMatch>& matches,
                                             std::size_t gap) {
  std::vector<CandidateGroup> groups;
  for (const KeyframeMatch& match : matches) {
    if (groups.empty() || match.position > groups.back().last + gap) {
      groups.push_back({match.position, match.position, match, match.score});
      continue;
    }
    CandidateGroup& group = groups.back();
    group.last = match.position;
    group.total_score += match.score;
    if (match.score > group.best.score) group.best = match;
  }
  std::stable_sort(groups.begin(), groups.end(),
                   [](const CandidateGroup& a, const CandidateGroup& b) {
                     return a.total_score > b.total_score;
                   });
  return groups;
}

}  // namespace cvo_slam
