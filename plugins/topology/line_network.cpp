#include "plugins/topology/line_network.hpp"

#include <algorithm>
#include <cmath>

namespace stope::topology {
namespace {

void reverse(Line& line) {
  std::swap(line.from, line.to);
  std::reverse(line.points.begin(), line.points.end());
}

}  // namespace

double distance_between(const LinePoint& a, const LinePoint& b) {
  return std::sqrt((a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y));
}

double length_of(const std::vector<LinePoint>& points) {
  double sum = 0;
  for (std::size_t i = 1; i < points.size(); ++i) sum += distance_between(points[i - 1], points[i]);
  return sum;
}

std::vector<std::vector<std::int32_t>> LineNetwork::lines_at_nodes() const {
  std::vector<std::vector<std::int32_t>> result(nodes.size());
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (lines[i].erased()) continue;
    result[static_cast<std::size_t>(lines[i].from)].push_back(static_cast<std::int32_t>(i));
    result[static_cast<std::size_t>(lines[i].to)].push_back(static_cast<std::int32_t>(i));
  }
  return result;
}

void LineNetwork::tidy() {
  auto at_nodes = lines_at_nodes();
  for (std::size_t node = 0; node < nodes.size(); ++node) {
    if (at_nodes[node].size() != 2 || at_nodes[node][0] == at_nodes[node][1]) continue;
    const std::int32_t kept = at_nodes[node][0], gone = at_nodes[node][1];
    Line& first = lines[static_cast<std::size_t>(kept)];
    Line& second = lines[static_cast<std::size_t>(gone)];
    if (first.to != static_cast<std::int32_t>(node)) reverse(first);
    if (second.from != static_cast<std::int32_t>(node)) reverse(second);
    first.points.insert(first.points.end(), second.points.begin() + 1, second.points.end());
    first.length += second.length;
    first.to = second.to;
    second.points.clear();
    auto& at_end = at_nodes[static_cast<std::size_t>(first.to)];
    *std::find(at_end.begin(), at_end.end(), gone) = kept;
    at_nodes[node].clear();
  }
  std::erase_if(lines, [](const Line& line) { return line.erased(); });
  std::vector<std::int32_t> place(nodes.size(), -1);
  for (const Line& line : lines)
    place[static_cast<std::size_t>(line.from)] = place[static_cast<std::size_t>(line.to)] = 0;
  std::vector<Node> used;
  for (std::size_t node = 0; node < nodes.size(); ++node) {
    if (place[node] < 0 && !nodes[node].alone) continue;
    place[node] = static_cast<std::int32_t>(used.size());
    used.push_back(nodes[node]);
  }
  for (Line& line : lines) {
    line.from = place[static_cast<std::size_t>(line.from)];
    line.to = place[static_cast<std::size_t>(line.to)];
  }
  nodes = std::move(used);
}

}  // namespace stope::topology
