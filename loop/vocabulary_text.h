// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string_view>

#include "cvo_slam/loop/vocabulary.h"

namespace cvo_slam {

/// The text format that ORB-SLAM2 and 3 and DBoW2 use for ORB vocabularies. The first line is
/// `branching levels scoring weighting`, where scoring 0 is L1 and weighting 0 is tf-idf, the only
/// ones known here. Then a node a line: `parent is_word d0 ... d31 weight`, with the bytes of the
/// descriptor in decimal. Nodes are counted from 1 in the order of lines; 0 is the root.
/// `name` is for messages. Throws InputError with the line.
[[nodiscard]] Vocabulary vocabulary_from_text(std::string_view text,
                                              const std::filesystem::path& name);

/// Writes that format, breadth first; weights with as many digits as read back the same. Throws
/// OutputError.
void write_vocabulary_text(const std::filesystem::path& file, const Vocabulary& vocabulary);

}  // namespace cvo_slam
