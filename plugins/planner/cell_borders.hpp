#pragma once

#include <cstdint>
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

/// Which links have their lower end at each place.
struct LinksByLower {
  std::vector<std::uint32_t> first;  ///< of each place; place count + 1
  std::vector<std::uint32_t> links;
  LinksByLower(std::uint32_t places, std::span<const CellLink> all);
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

}  // namespace stope::planner
