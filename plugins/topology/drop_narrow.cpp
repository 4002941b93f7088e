#include "plugins/topology/drop_narrow.hpp"

#include <algorithm>

namespace stope::topology {
namespace {

bool wide(const LinePoint& point, double least) { return point.distance >= least; }

}  // namespace

void drop_narrow(LineNetwork& network, double least_distance) {
  for (auto& node : network.nodes) node.alone = node.alone && wide(node.point, least_distance);
  const std::size_t count = network.lines.size();
  for (std::size_t i = 0; i < count; ++i) {
    const auto narrow = [&](const LinePoint& point) { return !wide(point, least_distance); };
    const auto& points = network.lines[i].points;
    if (std::none_of(points.begin(), points.end(), narrow)) continue;
    const Line line = std::move(network.lines[i]);
    network.lines[i].points.clear();
    for (auto begin = line.points.begin(); begin != line.points.end();) {
      begin = std::find_if_not(begin, line.points.end(), narrow);
      const auto end = std::find_if(begin, line.points.end(), narrow);
      if (end - begin >= 2) {
        Line part{line.from, line.to, {begin, end}, 0};
        part.length = length_of(part.points);
        const auto new_end = [&](const LinePoint& point) {
          network.nodes.push_back({point, false});
          return static_cast<std::int32_t>(network.nodes.size() - 1);
        };
        if (begin != line.points.begin()) part.from = new_end(part.points.front());
        if (end != line.points.end()) part.to = new_end(part.points.back());
        network.lines.push_back(std::move(part));
      }
      begin = end;
    }
  }
  network.tidy();
}

}  // namespace stope::topology
