// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/apps/page/run_page.h"

#include <system_error>

#include <fmt/format.h>

#include "cvo_slam/apps/page/html.h"
#include "cvo_slam/apps/page/page_style.h"
#include "cvo_slam/apps/page/run_sections.h"
#include "cvo_slam/apps/run_files.h"

namespace cvo_slam {
namespace {

/// The policy keeps the promise that the page asks nobody for anything.
std::string head(const std::string& title) {
  return fmt::format(
      "<head>\n<meta charset=\"utf-8\">\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; img-src data:; "
      "style-src 'unsafe-inline'\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<meta name=\"color-scheme\" content=\"light dark\">\n"
      "<link rel=\"icon\" href=\"data:,\">\n<title>{} - cvo_slam</title>\n<style>{}</style>\n"
      "</head>\n",
      html::escaped(title), page_style());
}

std::string title(const RunReport& report) {
  const FrameRange& range = report.range;
  std::string frames = fmt::format("frames {} to {}", range.begin, range.end - 1);
  if (range.step != 1) frames += fmt::format(", one in {}", range.step);
  const auto line = fmt::format("{} · mode {} · {} · camera {}", report.data.kind(), report.mode,
                                frames, report.data.camera().name);
  return html::element(
      "header", html::element("h1", html::escaped(report.data.name())) + html::paragraph(line));
}

}  // namespace

std::string files_section(const std::filesystem::path& folder) {
  std::string items;
  const auto add = [&](const std::string& name, const char* content) {
    std::error_code ignored;
    if (!std::filesystem::exists(folder / name, ignored)) return;
    const std::string link =
        html::element("a", html::escaped(name), fmt::format("href=\"{}\"", html::escaped(name)));
    items += html::element("li", link + html::escaped(content));
  };
  for (const RunFile& file : run_files()) {
    if (std::string_view(file.name) != "report.html") add(file.name, file.content);
  }
  add("loops", "pictures of recognised places, a PNG each");
  return html::section("files", "Files", html::element("ul", items, R"(class="files")"));
}

std::string run_page(const std::filesystem::path& folder, const RunReport& report,
                     const RunPictures& pictures) {
  const std::string body =
      title(report) +
      html::element("main", headline(report) + notes_section(report) +
                                map_section(report, pictures) + accuracy_section(report, pictures) +
                                tracking_section(report) + graph_section(report) +
                                loops_section(report, pictures) + cost_section(report) +
                                options_section(report) + files_section(folder)) +
      html::element("footer",
                    html::paragraph(fmt::format("Written by cvo_slam {}.", CVO_SLAM_VERSION)));
  return "<!DOCTYPE html>\n" + html::element("html",
                                             head(report.data.name()) + html::element("body", body),
                                             R"(lang="en")");
}

}  // namespace cvo_slam
