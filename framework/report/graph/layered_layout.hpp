#pragma once

#include <cstddef>
#include <vector>

/// Draws an acyclic graph from left to right in columns.
///
/// Problem: boxes of different heights, wires from ports at given heights; few crossings, short
/// and smooth wires, nothing on top of anything.
///
/// Idea, after Sugiyama, Tagawa and Toda (1981): each box goes into the column its longest way from
/// a source says, and a wire that passes a column gets a thin box of its own there. The order
/// within the columns comes from sweeps that sort by the mean height of the neighbours, of which
/// the one with the fewest crossings stays. Heights then come from the same means, made disjoint by
/// least squares (pooling of adjacent violators).
///
/// Cost: O(wires) a sweep, and O(wires^2) between two columns to count crossings.
namespace stope::report {

/// What is to be laid out. Edges go from lower to higher places of boxes.
struct LayoutProblem {
  struct Box {
    double height = 0;
    int earliest_column = 0;
  };
  struct Wire {
    std::size_t from = 0, to = 0;           ///< boxes
    double from_height = 0, to_height = 0;  ///< of the ports, below the boxes' upper edges
  };
  std::vector<Box> boxes;
  std::vector<Wire> wires;
  double gap = 24;  ///< between boxes of a column
  double lane = 8;  ///< what a passing wire takes
};

struct Layout {
  std::vector<int> column;  ///< by box
  std::vector<double> top;  ///< by box, from 0
  struct Bend {
    int column = 0;
    double height = 0;
  };
  std::vector<std::vector<Bend>> bends;  ///< by wire: where it passes columns between its ends
  int columns = 0;
  double height = 0;
};

Layout lay_out(const LayoutProblem& problem);

}  // namespace stope::report
