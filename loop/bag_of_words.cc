// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/loop/bag_of_words.h"

#include <algorithm>

namespace cvo_slam {

double bag_score(const BagOfWords& a, const BagOfWords& b) {
  // Both sum to 1, so that |a - b|_1 = 2 - 2 sum min(a, b).
  double score = 0;
  auto i = a.begin();
  auto j = b.begin();
  while (i != a.end() && j != b.end()) {
    if (i->word == j->word) {
      score += std::min(i->weight, j->weight);
      ++i;
      ++j;
    } else if (i->word < j->word) {
      ++i;
    } else {
      ++j;
    }
  }
  return score;
}

}  // namespace cvo_slam
