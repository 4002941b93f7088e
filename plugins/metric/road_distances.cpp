#include "plugins/metric/road_distances.hpp"

#include <algorithm>
#include <functional>
#include <queue>

namespace stope::metric {
namespace {
constexpr std::size_t kKeptNumbers = 32 << 20;
}

RoadDistances::RoadDistances(const RoadGraph& graph, const GraphLines& lines)
    : graph_(graph),
      lines_(lines),
      first_link_(graph.nodes.size() + 1),
      links_(2 * graph.edges.size()),
      place_of_node_(graph.nodes.size(), {static_cast<std::uint32_t>(graph.edges.size()), 0}),
      rows_(graph.nodes.size()),
      most_rows_(std::max<std::size_t>(8, kKeptNumbers / (graph.nodes.size() + 1))) {
  for (const RoadEdge& edge : graph.edges) {
    ++first_link_[edge.from + 1];
    ++first_link_[edge.to + 1];
  }
  for (std::size_t i = 1; i < first_link_.size(); ++i) first_link_[i] += first_link_[i - 1];
  std::vector<std::uint32_t> next(first_link_.begin(), first_link_.end() - 1);
  for (std::uint32_t e = 0; e < graph.edges.size(); ++e) {
    const RoadEdge& edge = graph.edges[e];
    const double length = lines.length(e);
    links_[next[edge.from]++] = {edge.to, length};
    links_[next[edge.to]++] = {edge.from, length};
    if (!has_road(edge.from)) place_of_node_[edge.from] = {e, 0};
    if (!has_road(edge.to)) place_of_node_[edge.to] = {e, length};
  }
}

std::vector<double> RoadDistances::search(const std::vector<Start>& starts, double reach) const {
  std::vector<double> distance(graph_.nodes.size(), kUnreachable);
  std::priority_queue<Start, std::vector<Start>, std::greater<>> open;
  const auto reached = [&](std::uint32_t node, double metres) {
    if (metres > reach || metres >= distance[node]) return;
    distance[node] = metres;
    open.emplace(metres, node);
  };
  for (const auto& [metres, node] : starts) reached(node, metres);
  while (!open.empty()) {
    const auto [metres, node] = open.top();
    open.pop();
    if (metres > distance[node]) continue;
    for (std::uint32_t i = first_link_[node]; i < first_link_[node + 1]; ++i)
      reached(links_[i].node, metres + links_[i].length);
  }
  return distance;
}

std::vector<double> RoadDistances::to_nodes(RoadPlace place, double reach) const {
  const RoadEdge& edge = graph_.edges[place.edge];
  return search({{place.along, edge.from}, {lines_.length(place.edge) - place.along, edge.to}},
                reach);
}

const std::vector<double>& RoadDistances::row(std::uint32_t node) {
  if (!rows_[node].empty()) return rows_[node];
  if (kept_.size() == most_rows_) {
    rows_[kept_.front()] = {};
    kept_.pop_front();
  }
  kept_.push_back(node);
  return rows_[node] = search({{0, node}}, kUnreachable);
}

double RoadDistances::between(RoadPlace a, RoadPlace b) {
  const RoadEdge &first = graph_.edges[a.edge], &second = graph_.edges[b.edge];
  const double a_rest = lines_.length(a.edge) - a.along, b_rest = lines_.length(b.edge) - b.along;
  const std::vector<double>& from = row(first.from);
  double best = a.along + std::min(from[second.from] + b.along, from[second.to] + b_rest);
  const std::vector<double>& to = row(first.to);
  best = std::min(best, a_rest + std::min(to[second.from] + b.along, to[second.to] + b_rest));
  return a.edge == b.edge ? std::min(best, std::abs(a.along - b.along)) : best;
}

}  // namespace stope::metric
