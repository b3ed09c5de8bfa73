// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include <fmt/format.h>

#include "cvo_slam/apps/graph_report.h"
#include "cvo_slam/apps/page/html.h"
#include "cvo_slam/apps/page/reasons.h"
#include "cvo_slam/apps/page/run_sections.h"
#include "cvo_slam/core/units.h"

namespace cvo_slam {
namespace {

using html::Cell;

std::string edges_text(const PoseGraph& graph) {
  return fmt::format(
      "{} keyframes; {} edges: {} of consecutive keyframes (odometry), {} of near ones "
      "(proximity), "
      "{} of places that were recognised (bow).",
      graph.nodes().size(), graph.edges().size(), edges_of_kind(graph, EdgeKind::kOdometry),
      edges_of_kind(graph, EdgeKind::kProximity), edges_of_kind(graph, EdgeKind::kLoop));
}

std::string verdict_table(const std::vector<LoopCandidate>& candidates) {
  html::Table table({{"found by"},
                     {"candidates", Cell::kNumber},
                     {"accepted", Cell::kNumber},
                     {"rejected", Cell::kNumber}});
  for (const EdgeKind kind : {EdgeKind::kProximity, EdgeKind::kLoop}) {
    std::size_t all = 0;
    std::size_t accepted = 0;
    for (const LoopCandidate& candidate : candidates) {
      if (candidate.kind != kind) continue;
      ++all;
      accepted += candidate.accepted ? 1 : 0;
    }
    table.add({std::string(name_of(kind)), fmt::to_string(all), fmt::to_string(accepted),
               fmt::to_string(all - accepted)});
  }
  return table.content();
}

std::string reason_table(const std::vector<LoopCandidate>& candidates) {
  html::Table table({{"found by"}, {"rejected", Cell::kNumber}, {"because"}});
  for (const ReasonCount& reason : count_reasons(candidates)) {
    table.add({std::string(name_of(reason.kind)), fmt::to_string(reason.count), reason.reason});
  }
  return table.empty() ? "" : table.content();
}

std::string loop_caption(const LoopCandidate& c) {
  const auto who = fmt::format("Frames {} and {}, {} inliers. ", c.from, c.to, c.inliers);
  if (!c.accepted) return who + "Rejected: " + c.reason + ".";
  return who + fmt::format(
                   "CVO: overlap {:.2f}, cos_theta {:.2f}. Corrected the graph by {}, {:.2f} "
                   "deg.",
                   c.overlap, c.cos_theta, length_text(c.correction_translation),
                   kDegrees * c.correction_rotation);
}

/// How the pictures were chosen.
std::string gallery_text(const LoopGallery& gallery) {
  constexpr const char* kWhat =
      "Each line joins what both images show at the same place, by their ORB features.";
  if (gallery.chosen.size() == gallery.files) return kWhat;
  return fmt::format(
      "{} of {} pictures; {} were left out. Here are those that corrected the graph most; all are "
      "in the folder loops. {}",
      gallery.chosen.size(), gallery.files, gallery.files - gallery.chosen.size(), kWhat);
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
    const char* why = report.loop_pictures == LoopPictures::kNone
                          ? "Pictures of loops were not asked for."
                          : "No loop was closed.";
    return html::section("loops", "Loops", html::paragraph(why));
  }
  std::string figures;
  for (const PicturedLoop& loop : gallery.chosen) {
    figures += html::figure(
        html::jpeg_image(loop.jpeg, fmt::format("Frames {} and {} with their inlier matches",
                                                loop.candidate.from, loop.candidate.to)),
        loop_caption(loop.candidate));
  }
  return html::section(
      "loops", "Loops",
      html::paragraph(gallery_text(gallery)) + html::element("div", figures, R"(class="gallery")"));
}

}  // namespace cvo_slam
