// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/apps/page/run_page.h"

#include <string_view>
#include <system_error>

#include <fmt/format.h>

#include "cvo_slam/apps/page/html.h"
#include "cvo_slam/apps/page/run_sections.h"
#include "cvo_slam/apps/run_files.h"

namespace cvo_slam {
namespace {

/// The style sheet, for screens (light and dark, wide and narrow) and for paper.
constexpr std::string_view kStyle = R"css(
:root {
  color-scheme: light dark;
  --ink: #1d2126; --soft: #5a636d; --line: #d9dde2; --paper: #ffffff; --field: #f5f6f8;
  --link: #0060a0; --bad: #b84400;
}
@media (prefers-color-scheme: dark) {
  :root {
    --ink: #e4e7eb; --soft: #9aa4af; --line: #353b43; --paper: #16191d; --field: #1f2328;
    --link: #6db8ee; --bad: #ff9a5c;
  }
}
* { box-sizing: border-box; }
html { -webkit-text-size-adjust: 100%; text-size-adjust: 100%; }
body {
  margin: 0 auto; max-width: 76rem; padding: 2.5rem 1.5rem 4rem;
  color: var(--ink); background: var(--paper);
  font: 1rem/1.55 system-ui, "Segoe UI", "Helvetica Neue", "DejaVu Sans", Arial, sans-serif;
}
h1, h2, h3 { line-height: 1.2; font-weight: 600; overflow-wrap: anywhere; }
h1 { margin: 0; font-size: 1.9rem; letter-spacing: -0.01em; }
header p { margin: 0.4rem 0 0; color: var(--soft); }
h2 { margin: 0 0 1rem; font-size: 1.3rem; }
h3 { margin: 2rem 0 0.6rem; font-size: 1rem; }
p, ul { margin: 0 0 1rem; max-width: 46rem; overflow-wrap: anywhere; }
section { margin-top: 2.8rem; padding-top: 1.6rem; border-top: 1px solid var(--line); }
a { color: var(--link); }
.tiles { display: flex; flex-wrap: wrap; gap: 0.75rem; margin: 1.8rem 0 0; }
.tiles div { flex: 1 1 min(14rem, 40%); padding: 0.8rem 1rem; background: var(--field); border-radius: 6px; }
.tiles dt { font-size: 0.85rem; color: var(--soft); }
.tiles dd { margin: 0; font-size: 0.85rem; color: var(--soft); }
.tiles b {
  display: block; font-size: 1.55rem; font-weight: 600; line-height: 1.35; color: var(--ink);
  font-variant-numeric: tabular-nums;
}
.tiles .bad b { color: var(--bad); }
figure { margin: 0 0 1.6rem; }
figure .frame { overflow-x: auto; background: #ffffff; border: 1px solid var(--line);
  border-radius: 6px; }
figure img, figure svg { display: block; width: 100%; height: auto; }
figure svg { min-width: 46rem; }
figcaption { margin-top: 0.5rem; font-size: 0.875rem; line-height: 1.45; color: var(--soft); }
.gallery { display: grid; grid-template-columns: repeat(auto-fill, minmax(min(30rem, 100%), 1fr));
  gap: 1.2rem; }
.gallery figure { margin: 0; }
.scroll { overflow-x: auto; margin: 0 0 1.6rem; }
table { border-collapse: collapse; font-size: 0.9rem; }
th, td { padding: 0.4rem 1.4rem 0.4rem 0; text-align: left; vertical-align: top; }
th { color: var(--soft); font-weight: 500; border-bottom: 1px solid var(--line);
  white-space: nowrap; }
td { border-bottom: 1px solid var(--line); }
td:first-child { min-width: 7.5rem; }
.number { text-align: right; font-variant-numeric: tabular-nums; white-space: nowrap; }
.code { font-family: ui-monospace, "DejaVu Sans Mono", Consolas, monospace; font-size: 0.82rem;
  white-space: nowrap; }
th.code { font: inherit; font-weight: 500; }
details { margin-bottom: 1.6rem; }
summary { cursor: pointer; color: var(--link); margin-bottom: 0.8rem; }
.files { padding: 0; list-style: none; font-size: 0.9rem; }
.files a { display: inline-block; min-width: 13rem; }
footer { margin-top: 3rem; font-size: 0.85rem; color: var(--soft); }
@media print {
  @page { margin: 14mm; }
  :root { --ink: #000000; --soft: #444444; --line: #cccccc; --paper: #ffffff; --field: #f4f4f4;
    --link: #000000; --bad: #b84400; }
  html { font-size: 9pt; }
  body { max-width: none; padding: 0; }
  section { margin-top: 1.4rem; padding-top: 0.9rem; }
  h2, h3 { break-after: avoid; }
  figure, tr, .tiles div { break-inside: avoid; }
  figure svg { min-width: 0; }
  .scroll, figure .frame { overflow: visible; }
  .tiles div { print-color-adjust: exact; -webkit-print-color-adjust: exact; }
  .tiles div { flex-basis: 20%; }
  .gallery { grid-template-columns: 1fr 1fr; gap: 0.6rem; }
  a { text-decoration: none; }
  details { display: none; }
}
)css";

/// Returns the head of the page. Its security policy forbids the page to load anything.
std::string head(const std::string& title) {
  return fmt::format(
      "<head>\n<meta charset=\"utf-8\">\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; img-src data:; "
      "style-src 'unsafe-inline'\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<meta name=\"color-scheme\" content=\"light dark\">\n"
      "<link rel=\"icon\" href=\"data:,\">\n<title>{} - cvo_slam</title>\n<style>{}</style>\n"
      "</head>\n",
      html::escaped(title), kStyle);
}

std::string title(const RunReport& report) {
  const FrameRange& range = report.range;
  std::string frames = fmt::format("frames {} to {}", range.begin, range.end - 1);
  if (range.step != 1) frames += fmt::format(", one in {}", range.step);
  const auto line = fmt::format("{} · mode {} · {} · camera {} ({}) · depth offset {}",
                                report.data.kind(), report.mode, frames, report.data.camera().name,
                                report.data.camera_origin(), report.clock.text());
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
  add("loops", "pictures of loop candidates, one PNG file each");
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
