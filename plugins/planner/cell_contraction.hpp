#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "plugins/planner/contraction_hierarchy.hpp"
#include "plugins/planner/nested_dissection.hpp"

namespace stope::planner {

/// A link between two nodes, as it goes into a hierarchy.
struct CellLink {
  std::uint32_t from = 0, to = 0;  ///< by place in the dissection's order
  std::uint32_t cost = 0;
  ContractionHierarchy::Parts parts;
};

/// Arcs that a hierarchy keeps, by the place of their lower end, then of their higher one.
struct KeptArcs {
  std::vector<std::uint32_t> first{0};  ///< of each lower end
  std::vector<SearchArc> arcs;          ///< to the higher end, by place
};

struct KeptHalves {
  KeptArcs up, down;  ///< from the lower end to the higher one, and the other way
};

/// The nodes next to each cell, by place: those after it that its nodes are linked to.
struct CellBorders {
  std::vector<std::uint32_t> first{0};  ///< of each cell; cell count + 1
  std::vector<std::uint32_t> places;    ///< ascending within a cell
  std::span<const std::uint32_t> of(std::uint32_t cell) const {
    return std::span(places).subspan(first[cell], first[cell + 1] - first[cell]);
  }
};

/// `links` may join any two places whose nodes the dissection allows to be joined.
CellBorders cell_borders(const Dissection& dissection, std::span<const CellLink> links);

/// Takes all nodes out in the dissection's order. Of the arcs and shortcuts between two nodes only
/// those are kept without which a cheapest way would be lost. The same on any number of threads.
/// See the .cpp for method and cost. Throws Error if a way costs 2^30 or more.
KeptHalves contract_cells(const Dissection& dissection, const CellBorders& borders,
                          std::span<const CellLink> links, const std::function<void()>& pause);

}  // namespace stope::planner
