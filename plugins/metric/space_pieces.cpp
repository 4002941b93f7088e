// Problem: count the pieces of free space and the holes in them that are large enough.
// Idea: rows are runs of free and of obstacle cells; runs of neighbouring rows that touch are
// joined (disjoint sets, roots the first run in raster order). What encloses a component is what
// lies left of its first run, because nothing of the component lies lower; so the components form a
// tree, and areas are summed up it. Cost: one pass over cells, memory by runs.
#include "plugins/metric/space_pieces.hpp"

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

namespace stope::metric {
namespace {

class DisjointSets {
 public:
  explicit DisjointSets(std::size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  }
  void add() { parent_.push_back(parent_.size()); }
  std::size_t root(std::size_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(std::size_t a, std::size_t b) {
    a = root(a), b = root(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<std::size_t> parent_;
};

struct Run {
  std::int32_t begin = 0, end = 0;  // columns, end excluded
  bool free = false;
};

constexpr std::size_t kOutside = 0;  // stands before all runs

class Components {
 public:
  explicit Components(const FreeCells& cells) : cells_(cells), runs_(1), sets_(1) {
    std::size_t before = 1;
    for (std::int32_t row = 0; row < cells.frame.height; ++row) {
      const std::size_t first = runs_.size();
      add_row(row);
      join_rows(before, first);
      before = first;
      const bool last = row + 1 == cells.frame.height;
      for (std::size_t i = first; i < runs_.size(); ++i) {
        const bool edge =
            row == 0 || last || runs_[i].begin == 0 || runs_[i].end == cells.frame.width;
        if (edge && !runs_[i].free) sets_.join(i, kOutside);
      }
    }
  }

  Betti count(double min_hole_cells, double min_piece_cells) {
    std::vector<double> own(runs_.size()), enclosed(runs_.size());
    for (std::size_t i = 1; i < runs_.size(); ++i)
      own[sets_.root(i)] += runs_[i].end - runs_[i].begin;
    for (std::size_t i = runs_.size() - 1; i > 0; --i) {
      if (sets_.root(i) != i) continue;
      enclosed[i] += own[i];
      enclosed[parent(i)] += enclosed[i];
    }
    Betti betti;
    std::vector<std::uint8_t> left_out(runs_.size());
    for (std::size_t i = 1; i < runs_.size(); ++i) {
      if (sets_.root(i) != i) continue;
      const double area = runs_[i].free ? own[i] : enclosed[i];
      left_out[i] =
          left_out[parent(i)] || area < (runs_[i].free ? min_piece_cells : min_hole_cells);
      if (!left_out[i]) ++(runs_[i].free ? betti.pieces : betti.holes);
    }
    return betti;
  }

 private:
  void add_row(std::int32_t row) {
    std::int32_t begin = 0;
    for (std::int32_t column = 1; column <= cells_.frame.width; ++column) {
      const bool free = cells_.at(begin, row);
      if (column < cells_.frame.width && cells_.at(column, row) == free) continue;
      runs_.push_back({begin, column, free});
      sets_.add();
      begin = column;
    }
  }
  // Both rows are walked at once, so that `below` and `above` always share a column.
  void join_rows(std::size_t below, std::size_t first) {
    std::size_t above = first;
    const std::size_t below_end = first, above_end = runs_.size();
    while (below < below_end && above < above_end) {
      const Run &a = runs_[below], &b = runs_[above];
      if (a.free == b.free) sets_.join(below, above);
      // Free runs that touch at a corner are the next but one to each other.
      if (a.free && above + 1 < above_end && runs_[above + 1].free && a.end == b.end)
        sets_.join(below, above + 1);
      if (b.free && below + 1 < below_end && runs_[below + 1].free && a.end == b.end)
        sets_.join(below + 1, above);
      if (a.end == b.end) {
        ++below;
        ++above;
      } else if (a.end < b.end) {
        ++below;
      } else {
        ++above;
      }
    }
  }
  std::size_t parent(std::size_t root) {
    return runs_[root].begin == 0 ? kOutside : sets_.root(root - 1);
  }

  const FreeCells& cells_;
  std::vector<Run> runs_;
  DisjointSets sets_;
};

}  // namespace

Betti betti_of_space(const FreeCells& cells, double min_hole_area, double min_piece_area) {
  const double cell = cells.frame.resolution * cells.frame.resolution;
  return Components(cells).count(min_hole_area / cell, min_piece_area / cell);
}

Betti betti_of_graph(const RoadGraph& graph) {
  DisjointSets sets(graph.nodes.size());
  for (const RoadEdge& edge : graph.edges) sets.join(edge.from, edge.to);
  Betti betti;
  for (std::size_t i = 0; i < graph.nodes.size(); ++i) betti.pieces += sets.root(i) == i ? 1 : 0;
  betti.holes = graph.edges.size() + betti.pieces - graph.nodes.size();
  return betti;
}

}  // namespace stope::metric
