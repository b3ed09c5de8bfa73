// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "cvo_slam/tests/architecture/source_file.h"

namespace cvo_slam::architecture {

/// What a rule found: "file:line: what is wrong; what to do", a line each.
using Findings = std::vector<std::string>;

/// A rule looks at one file. Lines count from 1.
using Rule = Findings (*)(const SourceFile&);

// Of includes (include_rules.cc)
Findings includes_are_spelled_from_the_root(const SourceFile& file);
Findings includes_follow_the_table(const SourceFile& file);
Findings public_headers_include_no_internal_ones(const SourceFile& file);
Findings internal_headers_stay_in_their_room(const SourceFile& file);
Findings sources_live_in_a_room(const SourceFile& file);

// Of what library code may do (code_rules.cc)
Findings libraries_do_not_print(const SourceFile& file);
Findings libraries_do_not_end_the_program(const SourceFile& file);
Findings libraries_do_not_sleep(const SourceFile& file);
Findings libraries_set_nothing_process_wide(const SourceFile& file);
Findings threads_belong_to_the_scheduler(const SourceFile& file);
// Of what any code may do
Findings memory_has_owners(const SourceFile& file);
Findings headers_open_no_namespaces(const SourceFile& file);

// Of files as such (file_rules.cc)
Findings headers_are_included_once(const SourceFile& file);
Findings licences_are_stated(const SourceFile& file);
Findings files_are_short(const SourceFile& file);
Findings nothing_is_left_to_do(const SourceFile& file);
Findings builds_are_portable(const SourceFile& file);

}  // namespace cvo_slam::architecture
