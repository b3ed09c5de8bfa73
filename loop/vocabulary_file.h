// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "cvo_slam/loop/vocabulary.h"

namespace cvo_slam {

/// Reads a vocabulary in either format, which its first bytes tell. Throws InputError where it
/// cannot be read, is cut off, damaged, of a later version, or no vocabulary.
[[nodiscard]] Vocabulary read_vocabulary(const std::filesystem::path& file);

/// Our binary format, which is read at once and whose bytes follow from the vocabulary alone.
/// All numbers are little-endian:
///
///   offset  bytes
///        0      8  "cvo-voc\n"
///        8      4  version of the format: 1
///       12      4  branching
///       16      4  levels
///       20      4  bits of a descriptor: 256
///       24      4  n, nodes with the root
///       28      4  w, words
///       32      8  checksum of all other bytes: FNV-1a over 64-bit words, zeros at the end
///       40      n  number of children of each node, breadth first; words have none
///           32n-32 descriptors of the nodes below the root
///               4w weights of the words (IEEE 754)
[[nodiscard]] std::string vocabulary_bytes(const Vocabulary& vocabulary);
/// `name` is for messages. Throws InputError.
[[nodiscard]] Vocabulary vocabulary_from_bytes(std::span<const char> bytes,
                                               const std::filesystem::path& name);

/// Throws OutputError.
void write_vocabulary(const std::filesystem::path& file, const Vocabulary& vocabulary);

}  // namespace cvo_slam
