// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <memory>
#include <span>

#include "cvo_slam/loop/vocabulary.h"

// The assembler copies the file's bytes into the read-only data: a C++ array of 2 MB costs a
// compiler a minute and a gigabyte. GNU's and LLVM's assemblers have .incbin.
// NOLINTNEXTLINE(hicpp-no-assembler)
asm(".pushsection .rodata\n"
    ".balign 8\n"
    ".hidden cvo_slam_vocabulary_begin\n"
    ".hidden cvo_slam_vocabulary_end\n"
    ".global cvo_slam_vocabulary_begin\n"
    ".global cvo_slam_vocabulary_end\n"
    "cvo_slam_vocabulary_begin:\n"
    ".incbin \"" CVO_SLAM_VOCABULARY_FILE
    "\"\n"
    "cvo_slam_vocabulary_end:\n"
    ".popsection\n");

extern "C" {
extern const char cvo_slam_vocabulary_begin;
extern const char cvo_slam_vocabulary_end;
}

namespace cvo_slam {

std::shared_ptr<const Vocabulary> builtin_vocabulary() {
  const std::span<const char> bytes(&cvo_slam_vocabulary_begin, &cvo_slam_vocabulary_end);
  return std::make_shared<const Vocabulary>(vocabulary_from_bytes(bytes, "built-in vocabulary"));
}

}  // namespace cvo_slam
