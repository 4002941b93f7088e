#include "plugins/road_source/drawn_roads.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>
#include <vector>

namespace stope::road_source {
namespace {

// How far the line of an edge may end from its nodes and still be meant to join them.
constexpr double kJoins = 0.05;

bool near(const RoadVertex& vertex, const RoadNode& node) {
  return std::hypot(vertex.x - node.x, vertex.y - node.y) <= kJoins;
}

bool same_line(const std::vector<RoadVertex>& a, const std::vector<RoadVertex>& b) {
  return std::equal(
      a.begin(), a.end(), b.rbegin(), b.rend(),
      [](const RoadVertex& p, const RoadVertex& q) { return p.x == q.x && p.y == q.y; });
}

class DrawnRoads {
 public:
  DrawnRoads(const RouteRecords& records, const RouteIndex& index, double clearance,
             AssembledRoads& result)
      : records_(records), index_(index), clearance_(clearance), result_(result) {}

  void add() {
    std::vector<const LinkRecord*> links;
    for (const LinkRecord& link : records_.links) {
      if (link.sequence == 0) links.push_back(&link);
    }
    std::sort(links.begin(), links.end(),
              [](const LinkRecord* a, const LinkRecord* b) { return a->id < b->id; });
    for (const LinkRecord* link : links) add(*link);
    if (elsewhere_ > 0) {
      result_.warnings.push_back(
          fmt::format("the lines of {} edges do not run from node to node; nav2 does not look at "
                      "lines, and they "
                      "are taken to be straight",
                      elsewhere_));
    }
  }

 private:
  void add(const LinkRecord& link) {
    const std::uint32_t from = index_.place_of(link.start, link.origin);
    const std::uint32_t to = index_.place_of(link.end, link.origin);
    std::vector<RoadVertex> line = line_of(link, from, to);
    const double speed_limit =
        link.speed_limit > 0 ? link.speed_limit : std::numeric_limits<double>::quiet_NaN();
    const auto waiting = one_way_.find({to, from});
    if (waiting != one_way_.end()) {
      for (auto other = waiting->second.begin(); other != waiting->second.end(); ++other) {
        RoadEdge& opposite = result_.roads.edges[*other];
        const auto its = result_.roads.polyline(opposite);
        const bool same_limit = opposite.speed_limit == speed_limit ||
                                (std::isnan(opposite.speed_limit) && std::isnan(speed_limit));
        if (!same_limit || !same_line(line, {its.begin(), its.end()})) continue;
        opposite.direction = RoadDirection::kBoth;
        waiting->second.erase(other);
        return;
      }
    }
    one_way_[{from, to}].push_back(result_.roads.edges.size());
    RoadEdge edge;
    edge.id = link.id;
    edge.from = from, edge.to = to;
    edge.first_vertex = static_cast<std::uint32_t>(result_.roads.vertices.size());
    edge.vertex_count = static_cast<std::uint32_t>(line.size());
    edge.width = 2 * clearance_;
    edge.speed_limit = speed_limit;
    edge.direction = RoadDirection::kForward;
    result_.roads.vertices.insert(result_.roads.vertices.end(), line.begin(), line.end());
    result_.roads.edges.push_back(edge);
  }

  std::vector<RoadVertex> line_of(const LinkRecord& link, std::uint32_t from, std::uint32_t to) {
    const RoadNode &a = result_.roads.nodes[from], &b = result_.roads.nodes[to];
    const auto begin = records_.vertices.begin() + link.first_vertex;
    std::vector<RoadVertex> line(begin, begin + link.vertex_count);
    if (line.size() >= 2 && !(near(line.front(), a) && near(line.back(), b)) &&
        near(line.front(), b) && near(line.back(), a)) {
      std::reverse(line.begin(), line.end());
    }
    if (line.size() < 2 || !near(line.front(), a) || !near(line.back(), b)) {
      elsewhere_ += line.empty() ? 0 : 1;
      line.assign(2, {});
    }
    line.front() = {a.x, a.y, a.z, 0};
    line.back() = {b.x, b.y, b.z, 0};
    for (RoadVertex& vertex : line) vertex.clearance = clearance_;
    return line;
  }

  const RouteRecords& records_;
  const RouteIndex& index_;
  double clearance_;
  AssembledRoads& result_;
  std::size_t elsewhere_ = 0;
  /// Roads one way that still lack an opposite, by the places of their nodes.
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::size_t>> one_way_;
};

}  // namespace

void add_drawn_roads(const RouteRecords& records, const RouteIndex& index, double clearance,
                     AssembledRoads& result) {
  DrawnRoads(records, index, clearance, result).add();
}

}  // namespace stope::road_source
