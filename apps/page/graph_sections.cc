// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <string>
#include <vector>

#include <fmt/format.h>

#include "cvo_slam/apps/graph_report.h"
#include "cvo_slam/apps/page/html.h"
#include "cvo_slam/apps/page/reasons.h"
#include "cvo_slam/apps/page/run_sections.h"
#include "cvo_slam/core/se3.h"

namespace cvo_slam {
namespace {

using html::Cell;

std::string edges_text(const PoseGraph& graph) {
  return fmt::format(
      "{} keyframes; {} edges: {} between consecutive keyframes (odometry), {} between near ones "
      "(proximity), {} from recognised places (bow).",
      graph.nodes().size(), graph.edges().size(), edges_of_kind(graph, EdgeKind::kOdometry),
      edges_of_kind(graph, EdgeKind::kProximity), edges_of_kind(graph, EdgeKind::kLoop));
}

std::string verdict_table(const std::vector<LoopCandidate>& candidates) {
  html::Table table({{"found by"},
                     {"candidates", Cell::kNumber},
                     {"accepted", Cell::kNumber},
                     {"rejected", Cell::kNumber}});
  for (const VerdictCount& count : count_verdicts(candidates)) {
    table.add({count.found_by, fmt::to_string(count.accepted + count.rejected),
               fmt::to_string(count.accepted), fmt::to_string(count.rejected)});
  }
  return table.content();
}

std::string reason_table(const std::vector<LoopCandidate>& candidates) {
  html::Table table({{"found by"}, {"rejected", Cell::kNumber}, {"because"}});
  for (const ReasonCount& reason : count_reasons(candidates)) {
    table.add({reason.found_by, fmt::to_string(reason.count), reason.reason});
  }
  return table.empty() ? "" : table.content();
}

std::string loop_caption(const LoopCandidate& c) {
  const auto who = fmt::format("Frames {} and {}, {} inliers. ", c.from, c.to, c.inliers);
  if (!c.accepted) return who + "Rejected: " + c.reason + ".";
  return who + fmt::format(
                   "Accepted: CVO overlap {:.2f}, cos_theta {:.2f}; corrected the graph by "
                   "{}, {:.2f} deg.",
                   c.overlap, c.cos_theta, length_text(c.correction_translation),
                   kDegrees * c.correction_rotation);
}

std::string loop_figures(const std::vector<PicturedLoop>& loops, bool accepted) {
  std::string figures;
  for (const PicturedLoop& loop : loops) {
    const LoopCandidate& candidate = loop.candidate;
    if (candidate.accepted != accepted) continue;
    const auto alternative =
        fmt::format("Frames {} and {} with their inlier matches", candidate.from, candidate.to);
    figures += html::figure(html::jpeg_image(loop.jpeg, alternative), loop_caption(candidate));
  }
  return figures.empty() ? "" : html::element("div", figures, R"(class="gallery")");
}

/// Returns a line on how the pictures were chosen.
std::string gallery_text(const LoopGallery& gallery) {
  constexpr const char* kWhat = "Each line joins two matching ORB features of the images.";
  if (gallery.chosen.size() == gallery.files) return kWhat;
  return fmt::format(
      "{} of {} pictures: the loops that corrected the graph most. The other {} are in the folder "
      "loops. {}",
      gallery.chosen.size(), gallery.files, gallery.files - gallery.chosen.size(), kWhat);
}

std::string_view why_no_picture(const RunReport& report) {
  switch (report.loop_pictures) {
    case LoopPictures::kNone:
      return "Pictures of loops were not asked for.";
    case LoopPictures::kAccepted:
      return "No loop was closed. The option --loop-pictures all shows the rejected candidates.";
    case LoopPictures::kAll:
      return "No place was recognised.";
  }
  return "";
}

}  // namespace

std::string graph_section(const RunReport& report) {
  if (!report.graph) return {};
  const GraphResult& graph = *report.graph;
  std::string content = html::paragraph(edges_text(graph.graph));
  if (graph.candidates.empty()) {
    content += html::paragraph("No other pair of keyframes was tried.");
  } else {
    content += verdict_table(graph.candidates) + reason_table(graph.candidates);
  }
  return html::section("graph", "Graph", content);
}

std::string loops_section(const RunReport& report, const RunPictures& pictures) {
  if (!report.graph || !report.options.slam.loops.enabled) return {};
  const LoopGallery& gallery = pictures.loops;
  if (gallery.files == 0) {
    return html::section("loops", "Loops", html::paragraph(why_no_picture(report)));
  }
  std::string content = html::paragraph(gallery_text(gallery)) + loop_figures(gallery.chosen, true);
  const std::string rejected = loop_figures(gallery.chosen, false);
  if (!rejected.empty()) content += html::element("h3", "Rejected") + rejected;
  return html::section("loops", "Loops", content);
}

}  // namespace cvo_slam
