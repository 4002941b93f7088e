// Problem: a way that leaves the roads' middles must still keep off closed roads and not go against
// one-way ones, and a grid knows nothing of roads.
// Idea: free ground is shared out among the roads as by a flood that rises from all of them at
// once: each cell keeps the piece of road that it was reached from, if that or a piece beside it is
// the nearest. A step from cell to cell is then judged as what it would be on the road itself.
// Cost: O(cells), with buckets of a quarter cell for a heap; 8 bytes a cell.
#include "plugins/planner/road_ground.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "plugins/planner/cell_line.hpp"

namespace stope::planner {

RoadGround::RoadGround(const DrivableGrid& grid, const RoadNetwork& network,
                       const RoadChanges& changes, const CellBox& box,
                       const std::vector<RoadVertex>& driven)
    : network_(&network), changes_(&changes), frame_(grid.frame()), box_(box) {
  const RoadGraph& graph = network.graph();
  const bool told = std::any_of(graph.edges.begin(), graph.edges.end(), [](const RoadEdge& edge) {
    return edge.closed || edge.direction != RoadDirection::kBoth;
  });
  if (!told && changes.empty()) return;
  for (const auto& [edge, change] : changes.all())
    slow_ = slow_ || (change.factor > 1 && change.factor != RoadChanges::kClosed);
  edge_of_.assign(graph.vertices.size(), kNone);
  for (std::uint32_t e = 0; e < graph.edges.size(); ++e)
    std::fill_n(edge_of_.begin() + graph.edges[e].first_vertex, graph.edges[e].vertex_count, e);
  for (const RoadVertex& vertex : graph.vertices)
    vertices_.push_back(grid.frame().to_grid(vertex.x, vertex.y));
  mark_driven(driven, grid.frame());
  flood(grid);
}

void RoadGround::mark_driven(const std::vector<RoadVertex>& driven, const GridFrame& frame) {
  driven_.assign(box_.size(), -1);
  std::int32_t count = 0;
  for (std::size_t i = 0; i + 1 < driven.size(); ++i) {
    walk_line_in(box_, frame.to_grid(driven[i].x, driven[i].y),
                 frame.to_grid(driven[i + 1].x, driven[i + 1].y),
                 [&](Cell cell) { driven_[box_.place(cell)] = count++; });
  }
}

RoadGround::Foot RoadGround::foot_on(std::uint32_t segment, const Vector2& point) const {
  const Vector2 &a = vertices_[segment], &b = vertices_[segment + 1];
  const Vector2 way = b - a;
  const double square = way.squaredNorm();
  const double share = square > 0 ? std::clamp((point - a).dot(way) / square, 0.0, 1.0) : 0;
  const double from = network_->along(segment), to = network_->along(segment + 1);
  return {(a + share * way - point).norm(), from + share * (to - from)};
}

void RoadGround::flood(const DrivableGrid& grid) {
  struct Entry {
    float distance;
    std::uint32_t place, segment;
  };
  constexpr float kBucketsACell = 4;
  segments_.assign(box_.size(), kNone);
  std::vector<float> nearest(box_.size(), std::numeric_limits<float>::infinity());
  std::vector<std::vector<Entry>> buckets;
  std::size_t now = 0;
  const auto reach = [&](Cell cell, std::uint32_t segment) {
    if (!box_.contains(cell) || !grid.free(cell)) return;
    const RoadEdge& edge = network_->graph().edges[edge_of_[segment]];
    const Vector2 centre(cell.column + 0.5, cell.row + 0.5);
    double best = foot_on(segment, centre).distance;
    // Along a bend the nearest piece changes from cell to cell.
    const auto take = [&](std::uint32_t other) {
      const double distance = foot_on(other, centre).distance;
      if (distance < best) best = distance, segment = other;
    };
    const std::uint32_t here = segment;
    if (here > edge.first_vertex) take(here - 1);
    if (here + 2 < edge.first_vertex + edge.vertex_count) take(here + 1);
    const auto distance = static_cast<float>(best);
    const std::uint32_t place = box_.place(cell);
    if (distance > nearest[place] || (distance == nearest[place] && segment >= segments_[place]))
      return;
    nearest[place] = distance;
    segments_[place] = segment;
    const auto bucket = std::max(now, static_cast<std::size_t>(distance * kBucketsACell));
    if (bucket >= buckets.size()) buckets.resize(bucket + 1);
    buckets[bucket].push_back({distance, place, segment});
  };
  for (const RoadEdge& edge : network_->graph().edges) {
    for (std::uint32_t i = 0; i + 1 < edge.vertex_count; ++i) {
      const std::uint32_t segment = edge.first_vertex + i;
      walk_line_in(box_, vertices_[segment], vertices_[segment + 1],
                   [&](Cell cell) { reach(cell, segment); });
    }
  }
  for (; now < buckets.size(); ++now) {
    for (std::size_t i = 0; i < buckets[now].size(); ++i) {
      const Entry entry = buckets[now][i];
      if (segments_[entry.place] != entry.segment || nearest[entry.place] != entry.distance)
        continue;
      const Cell cell = box_.cell(entry.place);
      reach({cell.column - 1, cell.row}, entry.segment);
      reach({cell.column + 1, cell.row}, entry.segment);
      reach({cell.column, cell.row - 1}, entry.segment);
      reach({cell.column, cell.row + 1}, entry.segment);
    }
    std::vector<Entry>().swap(buckets[now]);
  }
}

bool RoadGround::with_direction(std::uint32_t segment, const Vector2& direction) const {
  const RoadDirection driven = network_->graph().edges[edge_of_[segment]].direction;
  if (driven == RoadDirection::kBoth) return true;
  const double ahead = direction.dot(vertices_[segment + 1] - vertices_[segment]);
  return driven == RoadDirection::kForward ? ahead >= -1e-9 : ahead <= 1e-9;
}

bool RoadGround::passable(Cell from, Cell to, const Vector2& direction) const {
  if (open()) return true;
  const std::uint32_t a = box_.place(from), b = box_.place(to);
  constexpr std::int32_t kOnward = 3;
  if (driven_[a] >= 0 && driven_[b] >= 0 && std::abs(driven_[a] - driven_[b]) <= kOnward)
    return true;
  const std::uint32_t before = segments_[a], after = segments_[b];
  if (after != kNone) {
    const std::uint32_t edge = edge_of_[after];
    if (network_->graph().edges[edge].closed || changes_->closed(edge)) return false;
    if (!with_direction(after, direction)) return false;
  }
  if (before == kNone) return true;
  if (!with_direction(before, direction)) return false;
  if (after == kNone) return true;
  if (edge_of_[before] != edge_of_[after])
    return !both_cut_at(edge_of_[before], edge_of_[after], from);
  const auto along = [&](std::uint32_t segment, Cell cell) {
    return foot_on(segment, Vector2(cell.column + 0.5, cell.row + 0.5)).along;
  };
  const auto found = changes_->all().find(edge_of_[after]);
  return found == changes_->all().end() || found->second.cuts.empty() ||
         !changes_->blocked(edge_of_[after], along(before, from), along(after, to));
}

bool RoadGround::both_cut_at(std::uint32_t a, std::uint32_t b, Cell cell) const {
  const auto cut_here = [&](std::uint32_t edge) {
    const auto found = changes_->all().find(edge);
    if (found == changes_->all().end()) return false;
    return std::any_of(found->second.cuts.begin(), found->second.cuts.end(), [&](double along) {
      const RoadVertex cut = network_->at({edge, along});
      const Vector2 centre = frame_.centre(cell);
      return std::hypot(cut.x - centre.x(), cut.y - centre.y()) <= cut.clearance;
    });
  };
  return cut_here(a) && cut_here(b);
}

double RoadGround::factor(Cell cell) const {
  if (!slow_) return 1;
  const std::uint32_t segment = segments_[box_.place(cell)];
  return segment == kNone ? 1 : std::clamp(changes_->factor(edge_of_[segment]), 1.0, kMostFactor);
}

}  // namespace stope::planner
