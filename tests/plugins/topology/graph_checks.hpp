#pragma once

#include <algorithm>
#include <functional>
#include <numeric>
#include <vector>

#include "stope/payloads/occupancy_grid.hpp"
#include "stope/payloads/road_graph.hpp"

namespace stope::topology {

/// Numbers of pieces and of independent cycles or holes.
struct Betti {
  int pieces = 0, cycles = 0;
  bool operator==(const Betti&) const = default;
};

inline Betti betti_of(const RoadGraph& graph) {
  std::vector<std::size_t> parent(graph.nodes.size());
  std::iota(parent.begin(), parent.end(), std::size_t{0});
  const auto find = [&](std::size_t node) {
    while (parent[node] != node) node = parent[node] = parent[parent[node]];
    return node;
  };
  auto pieces = static_cast<int>(graph.nodes.size());
  for (const RoadEdge& edge : graph.edges) {
    const std::size_t a = find(edge.from), b = find(edge.to);
    if (a == b) continue;
    parent[a] = b;
    --pieces;
  }
  const auto edges = static_cast<int>(graph.edges.size());
  return {pieces, edges - static_cast<int>(graph.nodes.size()) + pieces};
}

/// By flooding: names of the pieces of obstacles (4-connected, the outside is piece 0) and of free
/// space (8-connected, -1 downwards), with a margin of one cell.
inline std::vector<int> label_pieces(const OccupancyGrid& grid, int& obstacles, int& frees) {
  const int width = grid.frame.width + 2, height = grid.frame.height + 2;
  const auto free = [&](int x, int y) {
    return x > 0 && y > 0 && x + 1 < width && y + 1 < height &&
           grid.cells[grid.frame.place({x - 1, y - 1})] == OccupancyGrid::kFree;
  };
  constexpr int kNone = 1 << 30;
  std::vector<int> label(static_cast<std::size_t>(width * height), kNone);
  obstacles = frees = 0;
  for (int start = 0; start < width * height; ++start) {
    if (label[static_cast<std::size_t>(start)] != kNone) continue;
    const bool is_free = free(start % width, start / width);
    const int name = is_free ? -++frees : obstacles++;
    std::vector<int> open{start};
    label[static_cast<std::size_t>(start)] = name;
    while (!open.empty()) {
      const int x = open.back() % width, y = open.back() / width;
      open.pop_back();
      for (int dy = -1; dy <= 1; ++dy) {
        for (int dx = -1; dx <= 1; ++dx) {
          const int u = x + dx, v = y + dy;
          if (u < 0 || v < 0 || u >= width || v >= height) continue;
          if (!is_free && dx != 0 && dy != 0) continue;
          int& there = label[static_cast<std::size_t>(v * width + u)];
          if (there != kNone || free(u, v) != is_free) continue;
          there = name;
          open.push_back(v * width + u);
        }
      }
    }
  }
  return label;
}

/// Of free space: 8-connected pieces, and holes, each an obstacle that does not hold the outside.
inline Betti betti_of(const OccupancyGrid& grid) {
  int obstacles = 0, frees = 0;
  label_pieces(grid, obstacles, frees);
  return {frees, obstacles - 1};
}

/// Areas of the holes of free space in square metres, by flooding, largest first.
inline std::vector<double> hole_areas(const OccupancyGrid& grid) {
  int obstacles = 0, frees = 0;
  std::vector<std::size_t> cells;
  for (const int label : label_pieces(grid, obstacles, frees)) {
    cells.resize(static_cast<std::size_t>(obstacles), 0);
    if (label >= 0) ++cells[static_cast<std::size_t>(label)];
  }
  std::vector<double> areas;
  for (std::size_t i = 1; i < cells.size(); ++i)
    areas.push_back(static_cast<double>(cells[i]) * grid.frame.resolution * grid.frame.resolution);
  std::sort(areas.begin(), areas.end(), std::greater<>());
  return areas;
}

inline std::vector<int> degrees_of(const RoadGraph& graph) {
  std::vector<int> degrees(graph.nodes.size(), 0);
  for (const RoadEdge& edge : graph.edges) {
    ++degrees[edge.from];
    ++degrees[edge.to];
  }
  return degrees;
}

inline std::vector<RoadNode> nodes_of_degree(const RoadGraph& graph, int degree) {
  const std::vector<int> degrees = degrees_of(graph);
  std::vector<RoadNode> result;
  for (std::size_t i = 0; i < graph.nodes.size(); ++i)
    if (degrees[i] == degree) result.push_back(graph.nodes[i]);
  return result;
}

}  // namespace stope::topology
