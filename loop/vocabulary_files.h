// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "cvo_slam/loop/vocabulary.h"

namespace cvo_slam {

/// Reads a vocabulary in either format, which its first bytes tell. Throws InputError if the file
/// cannot be read, is cut off, damaged, of a later version, or no vocabulary; the message says as
/// which format it was read.
[[nodiscard]] Vocabulary read_vocabulary(const std::filesystem::path& file);

/// Returns the bytes of the binary format of this library. They depend on the vocabulary alone.
/// All numbers are little-endian:
///
///     offset  bytes
///          0      8  "cvo-voc\n"
///          8      4  version of the format: 1
///         12      4  branching
///         16      4  levels
///         20      4  bits of a descriptor: 256
///         24      4  n, number of nodes including the root
///         28      4  w, number of words
///         32      8  checksum of all other bytes: FNV-1a over 64-bit words, padded with zeros
///         40      n  number of children of each node, breadth first; 0 for a word
///             32n-32 descriptors of the nodes below the root
///                 4w weights of the words (IEEE 754)
[[nodiscard]] std::string vocabulary_bytes(const Vocabulary& vocabulary);
/// Parses the binary format; `name` is for messages. Throws InputError.
[[nodiscard]] Vocabulary vocabulary_from_bytes(std::span<const char> bytes,
                                               const std::filesystem::path& name);
/// Writes a file in the binary format. Throws OutputError.
void write_vocabulary(const std::filesystem::path& file, const Vocabulary& vocabulary);

/// Parses the text format that ORB-SLAM2 and 3 and DBoW2 use for ORB vocabularies. The first line
/// is `branching levels scoring weighting`; only scoring 0 (L1) and weighting 0 (tf-idf) are
/// supported. Each following line is a node: `parent is_word d0 ... d31 weight`, with the bytes of
/// the descriptor in decimal. Nodes are numbered from 1 in the order of lines; 0 is the root.
/// `name` is for messages. Throws InputError with the line.
[[nodiscard]] Vocabulary vocabulary_from_text(std::string_view text,
                                              const std::filesystem::path& name);
/// Writes a file in the text format, breadth first; the weights have as many digits as are needed
/// to read them back unchanged. Throws OutputError.
void write_vocabulary_text(const std::filesystem::path& file, const Vocabulary& vocabulary);

}  // namespace cvo_slam
