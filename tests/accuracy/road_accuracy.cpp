// Problem: say how far a found road graph strays from the true one, without a network library.
// Idea: sample both every half metre and look up the nearest segment of the other in a uniform hash
// of segments. Cost: linear in the lengths.
#include "road_accuracy.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <vector>

namespace stope::testing {
namespace {

constexpr double kStep = 0.5;
constexpr double kBucket = 16.0;

struct Segment {
  Vector2 a, b;
  double width = 0;
};

struct Nearest {
  double distance = std::numeric_limits<double>::infinity();
  double width = 0;
};

// Finds the segment nearest to a point, if one lies within a bucket's size.
class SegmentIndex {
 public:
  explicit SegmentIndex(const RoadGraph& graph) {
    for (const RoadEdge& edge : graph.edges) {
      const auto line = graph.polyline(edge);
      for (std::size_t i = 1; i < line.size(); ++i)
        add({{line[i - 1].x, line[i - 1].y}, {line[i].x, line[i].y}, edge.width});
    }
  }
  Nearest nearest(const Vector2& point) const {
    Nearest best;
    const auto column = static_cast<long>(std::floor(point.x() / kBucket));
    const auto row = static_cast<long>(std::floor(point.y() / kBucket));
    for (long y = row - 1; y <= row + 1; ++y) {
      for (long x = column - 1; x <= column + 1; ++x) {
        const auto bucket = buckets_.find({y, x});
        if (bucket == buckets_.end()) continue;
        for (const Segment& segment : bucket->second) {
          const double distance = distance_to(segment, point);
          if (distance < best.distance) best = {distance, segment.width};
        }
      }
    }
    return best;
  }

 private:
  static double distance_to(const Segment& segment, const Vector2& point) {
    const Vector2 along = segment.b - segment.a;
    const double length = along.squaredNorm();
    const double t =
        length > 0 ? std::clamp((point - segment.a).dot(along) / length, 0.0, 1.0) : 0.0;
    return (segment.a + t * along - point).norm();
  }
  void add(const Segment& segment) {
    const auto low_x =
        static_cast<long>(std::floor(std::min(segment.a.x(), segment.b.x()) / kBucket));
    const auto high_x =
        static_cast<long>(std::floor(std::max(segment.a.x(), segment.b.x()) / kBucket));
    const auto low_y =
        static_cast<long>(std::floor(std::min(segment.a.y(), segment.b.y()) / kBucket));
    const auto high_y =
        static_cast<long>(std::floor(std::max(segment.a.y(), segment.b.y()) / kBucket));
    for (long y = low_y; y <= high_y; ++y) {
      for (long x = low_x; x <= high_x; ++x) buckets_[{y, x}].push_back(segment);
    }
  }
  std::map<std::pair<long, long>, std::vector<Segment>> buckets_;
};

std::vector<std::size_t> degrees(const RoadGraph& graph) {
  std::vector<std::size_t> degree(graph.nodes.size());
  for (const RoadEdge& edge : graph.edges) {
    ++degree[edge.from];
    ++degree[edge.to];
  }
  return degree;
}

// The true nodes around which the midline need not be the centre line.
class Exceptions {
 public:
  Exceptions(const RoadGraph& truth, const AccuracyRules& rules) {
    const auto degree = degrees(truth);
    std::vector<double> width(truth.nodes.size());
    for (const RoadEdge& edge : truth.edges) {
      width[edge.from] = std::max(width[edge.from], edge.width);
      width[edge.to] = std::max(width[edge.to], edge.width);
    }
    for (std::size_t i = 0; i < truth.nodes.size(); ++i) {
      const Vector2 place(truth.nodes[i].x, truth.nodes[i].y);
      if (degree[i] == 1) {
        dead_ends.push_back({place, width[i]});
        around_.push_back({place, width[i] * rules.dead_end_margin});
      } else if (degree[i] > 2) {
        around_.push_back({place, width[i] * rules.junction_margin});
      }
    }
  }
  bool cover(const Vector2& point) const {
    return std::any_of(around_.begin(), around_.end(),
                       [&](const Disc& disc) { return (disc.centre - point).norm() < disc.size; });
  }
  struct Disc {
    Vector2 centre;
    double size;
  };
  std::vector<Disc> dead_ends;  // size: the road's width

 private:
  std::vector<Disc> around_;
};

void sample(const RoadGraph& graph, const std::function<void(const Vector2&, double)>& visit) {
  for (const RoadEdge& edge : graph.edges) {
    const auto line = graph.polyline(edge);
    for (std::size_t i = 1; i < line.size(); ++i) {
      const Vector2 a(line[i - 1].x, line[i - 1].y), b(line[i].x, line[i].y);
      const double length = (b - a).norm();
      const auto pieces = static_cast<int>(std::ceil(length / kStep));
      for (int piece = 0; piece < pieces; ++piece) {
        visit(a + (piece + 0.5) / pieces * (b - a), length / pieces);
      }
    }
  }
}

void count_dead_ends(const RoadGraph& found, const Exceptions& exceptions,
                     const AccuracyRules& rules, RoadAccuracy& accuracy) {
  const auto degree = degrees(found);
  const auto near = [&](const Exceptions::Disc& truth, std::size_t node) {
    return degree[node] == 1 &&
           (Vector2(found.nodes[node].x, found.nodes[node].y) - truth.centre).norm() <=
               rules.dead_end_tolerance * truth.size;
  };
  accuracy.dead_ends = exceptions.dead_ends.size();
  for (const auto& truth : exceptions.dead_ends) {
    bool seen = false;
    for (std::size_t node = 0; node < found.nodes.size() && !seen; ++node) seen = near(truth, node);
    accuracy.dead_ends_found += seen ? 1 : 0;
  }
  for (std::size_t node = 0; node < found.nodes.size(); ++node) {
    if (degree[node] != 1) continue;
    const bool known = std::any_of(exceptions.dead_ends.begin(), exceptions.dead_ends.end(),
                                   [&](const auto& truth) { return near(truth, node); });
    accuracy.spurs += known ? 0 : 1;
  }
}

}  // namespace

long cycles(const RoadGraph& graph) {
  std::vector<std::size_t> parent(graph.nodes.size());
  std::iota(parent.begin(), parent.end(), std::size_t{0});
  const auto root = [&](std::size_t node) {
    while (parent[node] != node) node = parent[node] = parent[parent[node]];
    return node;
  };
  long count = 0;
  for (const RoadEdge& edge : graph.edges) {
    const std::size_t a = root(edge.from), b = root(edge.to);
    if (a == b) {
      ++count;
    } else {
      parent[a] = b;
    }
  }
  return count;
}

RoadAccuracy measure_roads(const RoadGraph& found, const RoadGraph& truth,
                           const AccuracyRules& rules) {
  RoadAccuracy accuracy;
  const SegmentIndex true_lines(truth), found_lines(found);
  const Exceptions exceptions(truth, rules);
  sample(found, [&](const Vector2& point, double length) {
    const Nearest nearest = true_lines.nearest(point);
    if (!(nearest.distance <= 0.5 * nearest.width) || exceptions.cover(point)) return;
    accuracy.length_in_roads += length;
    if (nearest.distance <= rules.tolerance) accuracy.length_near += length;
  });
  sample(truth, [&](const Vector2& point, double length) {
    if (exceptions.cover(point)) return;
    accuracy.true_length += length;
    if (found_lines.nearest(point).distance <= rules.tolerance)
      accuracy.true_length_found += length;
  });
  count_dead_ends(found, exceptions, rules, accuracy);
  accuracy.cycles = cycles(found);
  accuracy.true_cycles = cycles(truth);
  return accuracy;
}

}  // namespace stope::testing
