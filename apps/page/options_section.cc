// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <string>
#include <vector>

#include <fmt/format.h>

#include "cvo_slam/apps/page/html.h"
#include "cvo_slam/apps/page/run_sections.h"
#include "cvo_slam/core/options.h"

namespace cvo_slam {

std::string options_section(const RunReport& report) {
  using html::Cell;
  ProgramOptions used = report.options;
  ProgramOptions defaults;
  const OptionSet default_set = describe(defaults);
  html::Table changed({{"option", Cell::kCode},
                       {"value", Cell::kCode},
                       {"default", Cell::kCode},
                       {"unit"},
                       {"what it is"}});
  html::Table unchanged(
      {{"option", Cell::kCode}, {"value", Cell::kCode}, {"unit"}, {"what it is"}});
  std::size_t count = 0;
  for (const Option& option : describe(used).options()) {
    const std::string value = option.get();
    const std::string usual = default_set.get(option.key);
    if (value == usual) {
      unchanged.add({option.key, value, option.unit, option.doc});
    } else {
      changed.add({option.key, value, usual, option.unit, option.doc});
      ++count;
    }
  }
  std::string content =
      count == 0 ? html::paragraph("All options are the defaults.")
                 : html::paragraph(fmt::format("{} {} not the default:", count,
                                               count == 1 ? "option is" : "options are")) +
                       changed.content();
  content +=
      html::element("details", html::element("summary", "The options that are the defaults") +
                                   unchanged.content());
  return html::section("options", "Options", content);
}

}  // namespace cvo_slam
