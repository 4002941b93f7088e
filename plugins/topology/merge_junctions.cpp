#include "plugins/topology/merge_junctions.hpp"

#include <algorithm>
#include <functional>
#include <queue>
#include <tuple>

namespace stope::topology {
namespace {

std::size_t at(std::int32_t place) { return static_cast<std::size_t>(place); }

class JunctionMerger {
 public:
  JunctionMerger(LineNetwork& network, double share, bool to_rim)
      : network_(network),
        courses_(*network.courses),
        share_(share),
        to_rim_(to_rim),
        at_nodes_(network.nodes.size()) {
    for (std::size_t i = 0; i < network.lines.size(); ++i)
      for (const std::int32_t node : {network.lines[i].from, network.lines[i].to})
        at_nodes_[at(node)].push_back(static_cast<std::int32_t>(i));
  }

  void run() {
    for (std::size_t i = 0; i < network_.lines.size(); ++i) offer(static_cast<std::int32_t>(i));
    while (!open_.empty()) {
      const auto [length, line] = open_.top();
      open_.pop();
      const Line& candidate = network_.lines[at(line)];
      if (!candidate.erased() && candidate.length == length && mergeable(candidate)) merge(line);
    }
    network_.tidy();
  }

 private:
  using Entry = std::pair<double, std::int32_t>;

  void offer(std::int32_t line) {
    const Line& candidate = network_.lines[at(line)];
    if (!candidate.erased() && mergeable(candidate)) open_.emplace(candidate.length, line);
  }

  bool mergeable(const Line& line) const {
    if (line.from == line.to) return false;
    if (at_nodes_[at(line.from)].size() < 3 || at_nodes_[at(line.to)].size() < 3) return false;
    const double reach = share_ * std::min(network_.nodes[at(line.from)].point.distance,
                                           network_.nodes[at(line.to)].point.distance);
    if (line.length > reach) return false;
    const auto joins = [&](std::int32_t other) {
      const Line& o = network_.lines[at(other)];
      return std::minmax(o.from, o.to) == std::minmax(line.from, line.to);
    };
    const auto& around = at_nodes_[at(line.from)];
    return std::count_if(around.begin(), around.end(), joins) == 1;
  }

  void merge(std::int32_t name) {
    const Line line = network_.lines[at(name)];
    const LinePoint middle = middle_of(line);
    const double reach = std::max({distance_between(middle, courses_.front(line.course)),
                                   distance_between(middle, courses_.back(line.course)),
                                   to_rim_ ? middle.distance : 0.0});
    network_.set_course(network_.lines[at(name)], kNoCourse);
    std::vector<std::int32_t> around;
    for (const std::int32_t node : {line.from, line.to})
      for (const std::int32_t other : at_nodes_[at(node)])
        if (other != name) around.push_back(other);
    for (const std::int32_t other : around) {
      Line& moved = network_.lines[at(other)];
      // A line from a junction to itself is met twice, once for each end.
      if (moved.from == line.from || moved.from == line.to)
        move_start(moved, line.from, middle, reach);
      if (moved.to == line.from || moved.to == line.to) {
        moved.reverse();
        move_start(moved, line.from, middle, reach);
        moved.reverse();
      }
    }
    network_.nodes[at(line.from)].point = middle;
    at_nodes_[at(line.from)] = around;
    at_nodes_[at(line.to)].clear();
    for (const std::int32_t other : around) offer(other);
  }

  LinePoint middle_of(const Line& line) const {
    const CourseView points = network_.points(line);
    double left = line.length / 2;
    for (std::size_t i = 1; i < points.size(); ++i) {
      const LinePoint &a = points[i - 1], &b = points[i];
      const double step = distance_between(a, b);
      if (step > 0 && left <= step) {
        const double part = left / step;
        return {a.x + part * (b.x - a.x), a.y + part * (b.y - a.y),
                a.distance + part * (b.distance - a.distance)};
      }
      left -= step;
    }
    return points.back();
  }

  /// Lets a line start at a junction's new place, straight from where it leaves the junction.
  void move_start(Line& line, std::int32_t node, const LinePoint& place, double reach) {
    line.from = node;
    CourseKey key(CourseKey::kMoved);
    key.add(courses_.name(line.course)).add(place).add(reach);
    const Courses::Made& moved = courses_.make(key, [&] {
      const CourseView points = network_.points(line);
      std::size_t first = 1;
      while (first + 1 < points.size() && distance_between(points[first], place) <= reach) ++first;
      std::vector<LinePoint> rest = points.copy(first - 1, points.size());
      rest.front() = place;
      return Courses::Made{{courses_.add(std::move(rest))}, {}, 0};
    });
    network_.set_course(line, moved.courses[0]);
  }

  LineNetwork& network_;
  Courses& courses_;
  double share_;
  bool to_rim_;
  std::vector<std::vector<std::int32_t>> at_nodes_;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open_;
};

}  // namespace

void merge_junctions(LineNetwork& network, double share, bool to_rim) {
  JunctionMerger(network, share, to_rim).run();
}

}  // namespace stope::topology
