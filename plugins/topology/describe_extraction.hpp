#pragma once

#include <fmt/format.h>

#include <string>
#include <string_view>

#include "plugins/topology/disjoint_sets.hpp"
#include "plugins/topology/extract_roads.hpp"
#include "plugins/topology/give_elevation.hpp"
#include "stope/about.hpp"
#include "stope/context.hpp"
#include "stope/error.hpp"

namespace stope::topology {

/// The family's common parameters.
template <class Stage>
void describe_extraction(About<Stage>& about) {
  about.in_order();  // where a grid says what has changed, the rest is remembered
  about
      .param("min_clearance", &ExtractionParams::min_clearance, "m", at_least(0.0),
             "Drops the parts of roads narrower than twice this.")
      .param("min_obstacle_area", &ExtractionParams::min_obstacle_area, "m^2", at_least(0.0),
             "Obstacles (4-connected, with what they enclose) smaller than this count as free.")
      .param("simplify", &ExtractionParams::simplify, "m", at_least(0.0),
             "How far a simplified centre line may be off; never more than a quarter of its "
             "clearance.")
      .param("occupied_threshold", &ExtractionParams::occupied_threshold, between(0.0, 1.0),
             "Least probability with which a cell is an obstacle.")
      .param("unknown_is_obstacle", &ExtractionParams::unknown_is_obstacle,
             "Whether unknown cells are obstacles; otherwise they are free.")
      .param("allow_empty", &ExtractionParams::allow_empty,
             "Give a graph without roads instead of an error, for streams of live grids.");
}

/// Of members whose lines are those of the medial axis, or of a part of it.
template <class Stage>
void describe_lines(About<Stage>& about) {
  about.param(
      "medial_lines", &ExtractionParams::medial_lines,
      "Whether lines stay on the exact medial axis, with the greatest clearance, which bends "
      "into every opening. Otherwise roads go straight on where others join them, and meet "
      "where their own centre lines do.");
}

/// Of members that keep roads that end.
template <class Stage>
void describe_branches(About<Stage>& about) {
  about
      .param("min_branch", &BranchParams::min_branch, "m", at_least(0.0),
             "A branch that ends must reach this much further than the inscribed circle at its "
             "root.")
      .param("min_branch_share", &BranchParams::min_branch_share, between(0.0, 10.0),
             "… and this share of that circle's radius; corners reach 0.41.");
}

/// Why such a member found no road.
inline std::string why_no_branches(const ExtractionParams& params, const BranchParams& branches) {
  return fmt::format(
      "every way is narrower than twice min_clearance ({} m), or no branch is as long as "
      "min_branch ({} m) and min_branch_share ({}) ask for; lower them, or check the map's "
      "resolution",
      params.min_clearance, branches.min_branch, branches.min_branch_share);
}

/// The number of pieces of a network that no road connects.
inline std::size_t count_pieces(const RoadGraph& roads) {
  DisjointSets connected(roads.nodes.size());
  std::size_t pieces = roads.nodes.size();
  for (const RoadEdge& edge : roads.edges)
    pieces -=
        connected.join(static_cast<std::int32_t>(edge.from), static_cast<std::int32_t>(edge.to))
            ? 1U
            : 0U;
  return pieces;
}

/// Logs what was found. Without any road throws Error unless params.allow_empty; `why` ends the
/// sentence "the map has free cells but no road that can be extracted: …", and `apart`, if given,
/// "the roads are … networks of their own: …".
inline void report_roads(const RoadGraph& roads, const ExtractionParams& params,
                         std::string_view why, Context& context, std::string apart = {}) {
  if (!roads.edges.empty()) {
    context.info(fmt::format("{} {} in {} {}", roads.edges.size(),
                             roads.edges.size() == 1 ? "road meets or ends" : "roads meet or end",
                             roads.nodes.size(), roads.nodes.size() == 1 ? "place" : "places"));
    const std::size_t pieces = count_pieces(roads);
    if (apart.empty())
      apart = fmt::format("no way wider than twice min_clearance ({} m) connects them",
                          params.min_clearance);
    if (pieces > 1)
      context.info(fmt::format("the roads are {} networks of their own: {}", pieces, apart));
    return;
  }
  const std::string sentence =
      roads.nodes.empty()
          ? fmt::format("the map has free cells but no road that can be extracted: {}", why)
          : fmt::format(
                "the map has free cells but no road that can be extracted: it has {} open {}, and "
                "no way from one to another or into a dead end; {}",
                roads.nodes.size(), roads.nodes.size() == 1 ? "place" : "places", why);
  if (!params.allow_empty)
    throw Error(sentence + " (with allow_empty: true a graph without roads is passed on)");
  context.warn(sentence);
}

}  // namespace stope::topology
