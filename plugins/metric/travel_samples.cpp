#include "plugins/metric/travel_samples.hpp"

#include <algorithm>
#include <cmath>

namespace stope::metric {
namespace {

// Lengths of sums of many roads are compared with multiples of the interval.
constexpr double kRounding = 1e-6;

class Sampler {
 public:
  Sampler(const MeasuredGraph& graph, double interval, double reach)
      : graph_(graph), interval_(interval), reach_(reach) {}

  // Points inside the part of an edge that begins at `along` and is `length` long, whose ends are
  // `begin` and `end` metres of travel from the start.
  void add_inside(std::uint32_t edge, double along, double length, double begin, double end) {
    add_side(edge, along, length, begin, end, true);
    add_side(edge, along, length, end, begin, false);
  }
  void add_node(std::uint32_t node, double travel) {
    const double steps = std::round(travel / interval_);
    if (steps < 1 || travel > reach_ + kRounding) return;
    if (std::abs(travel - steps * interval_) > kRounding) return;
    points_.emplace_back(graph_.graph.nodes[node].x, graph_.graph.nodes[node].y);
  }
  std::vector<Vector2> take() { return std::move(points_); }

 private:
  // From one end on, as far as the way from this end is the shorter; where both are equal only
  // the first end gives the point.
  void add_side(std::uint32_t edge, double along, double length, double travel, double other_travel,
                bool first) {
    if (travel > reach_) return;
    const double half = std::min(length, 0.5 * (other_travel + length - travel));
    for (double steps = std::max(1.0, std::ceil(travel / interval_ - kRounding));; ++steps) {
      const double inside = steps * interval_ - travel;
      if (steps * interval_ > reach_ + kRounding || inside > length - kRounding) return;
      if (first ? inside > half + kRounding : inside >= half - kRounding) return;
      if (inside < kRounding) continue;
      points_.push_back(
          graph_.lines.position({edge, first ? along + inside : along + length - inside}));
    }
  }

  const MeasuredGraph& graph_;
  double interval_, reach_;
  std::vector<Vector2> points_;
};

}  // namespace

std::vector<Vector2> travel_samples(const MeasuredGraph& graph, RoadPlace start, double interval,
                                    double reach) {
  const std::vector<double> travel = graph.distances.to_nodes(start, reach + kRounding);
  Sampler sampler(graph, interval, reach);
  for (std::uint32_t e = 0; e < graph.graph.edges.size(); ++e) {
    const RoadEdge& edge = graph.graph.edges[e];
    const double length = graph.lines.length(e);
    if (e == start.edge) {
      sampler.add_inside(e, 0, start.along, travel[edge.from], 0);
      sampler.add_inside(e, start.along, length - start.along, 0, travel[edge.to]);
    } else {
      sampler.add_inside(e, 0, length, travel[edge.from], travel[edge.to]);
    }
  }
  for (std::uint32_t node = 0; node < graph.graph.nodes.size(); ++node)
    sampler.add_node(node, travel[node]);
  return sampler.take();
}

}  // namespace stope::metric
