// Graph colouring in smallest-last order (Matula and Beck, 1983): the vertex with the fewest
// neighbours is taken away again and again, and colours are given in the reverse of that order, so
// that each vertex meets at most `degeneracy` coloured neighbours. Connected pieces that touch
// along sides or at corners form a 1-planar graph, whose degeneracy is at most 7, so 8 hues always
// do for pieces; whole regions nearly always need no more than 6. Of the hues left to a vertex it
// takes the one farthest from its neighbours' on the circle of hues. Cost: linear in vertices and
// edges.
#include "plugins/export/region_colours.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <optional>

#include "stope/error.hpp"

namespace stope::exports {
namespace {

constexpr std::array kHueCounts{6, 12, 18};
constexpr std::uint8_t kNone = 255;

using Pairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

/// Neighbours of each vertex, as one list with offsets.
struct Graph {
  std::vector<std::size_t> begin;
  std::vector<std::uint32_t> neighbours;
  std::size_t size() const { return begin.size() - 1; }
};

Graph graph_of(std::size_t count, Pairs pairs) {
  for (auto& [a, b] : pairs) {
    if (a > b) std::swap(a, b);
  }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  Graph graph;
  graph.begin.assign(count + 1, 0);
  for (const auto& [a, b] : pairs) {
    if (a == b) continue;
    ++graph.begin[a + 1];
    ++graph.begin[b + 1];
  }
  for (std::size_t i = 0; i < count; ++i) graph.begin[i + 1] += graph.begin[i];
  graph.neighbours.resize(graph.begin[count]);
  std::vector<std::size_t> next(graph.begin.begin(), graph.begin.end() - 1);
  for (const auto& [a, b] : pairs) {
    if (a == b) continue;
    graph.neighbours[next[a]++] = b;
    graph.neighbours[next[b]++] = a;
  }
  return graph;
}

std::vector<std::uint32_t> smallest_last(const Graph& graph) {
  const std::size_t count = graph.size();
  std::vector<std::size_t> degree(count);
  std::vector<std::vector<std::uint32_t>> buckets;
  for (std::size_t i = count; i-- > 0;) {
    degree[i] = graph.begin[i + 1] - graph.begin[i];
    if (degree[i] >= buckets.size()) buckets.resize(degree[i] + 1);
    buckets[degree[i]].push_back(static_cast<std::uint32_t>(i));
  }
  std::vector<bool> taken(count);
  std::vector<std::uint32_t> order;
  order.reserve(count);
  for (std::size_t low = 0; order.size() < count;) {
    if (buckets[low].empty()) {
      ++low;
      continue;
    }
    const std::uint32_t vertex = buckets[low].back();
    buckets[low].pop_back();
    if (taken[vertex] || degree[vertex] != low) continue;  // an entry of before
    taken[vertex] = true;
    order.push_back(vertex);
    for (std::size_t k = graph.begin[vertex]; k < graph.begin[vertex + 1]; ++k) {
      const std::uint32_t other = graph.neighbours[k];
      if (!taken[other]) buckets[--degree[other]].push_back(other);
    }
    if (low > 0) --low;
  }
  std::reverse(order.begin(), order.end());
  return order;
}

/// Colours with this many hues, if the order allows.
std::optional<std::vector<std::uint8_t>> coloured(const Graph& graph,
                                                  const std::vector<std::uint32_t>& order,
                                                  int hues) {
  std::vector<std::uint8_t> colour(graph.size(), kNone);
  std::vector<std::size_t> used(static_cast<std::size_t>(hues));
  for (const std::uint32_t vertex : order) {
    std::vector<int> distance(static_cast<std::size_t>(hues), hues);
    for (std::size_t k = graph.begin[vertex]; k < graph.begin[vertex + 1]; ++k) {
      const int other = colour[graph.neighbours[k]];
      if (other == kNone) continue;
      for (int hue = 0; hue < hues; ++hue) {
        const int apart = std::abs(hue - other);
        int& least = distance[static_cast<std::size_t>(hue)];
        least = std::min({least, apart, hues - apart});
      }
    }
    std::size_t best = 0;
    for (std::size_t hue = 1; hue < distance.size(); ++hue) {
      if (distance[hue] > distance[best] ||
          (distance[hue] == distance[best] && used[hue] < used[best]))
        best = hue;
    }
    if (distance[best] == 0) return std::nullopt;
    colour[vertex] = static_cast<std::uint8_t>(best);
    ++used[best];
  }
  return colour;
}

}  // namespace

RegionColours colour_regions(const RegionMap& map, const RegionPieces& pieces) {
  Pairs between_regions;
  for (const auto& [a, b] : pieces.contacts)
    between_regions.emplace_back(pieces.region[a], pieces.region[b]);
  for (std::size_t i = 0; i + 1 < map.adjacency.size(); i += 2)
    between_regions.emplace_back(map.adjacency[i], map.adjacency[i + 1]);
  RegionColours result;
  const Graph regions = graph_of(map.regions.size(), std::move(between_regions));
  const auto order = smallest_last(regions);
  for (const int hues : kHueCounts) {
    if (const auto colours = coloured(regions, order, hues)) {
      result.hues = hues;
      result.of_region = *colours;
      for (const std::uint32_t region : pieces.region)
        result.of_piece.push_back(result.of_region[region]);
      return result;
    }
  }
  const Graph touching = graph_of(pieces.region.size(), pieces.contacts);
  const auto piece_order = smallest_last(touching);
  for (const int hues : kHueCounts) {
    if (const auto colours = coloured(touching, piece_order, hues)) {
      result.hues = hues;
      result.of_piece = *colours;
      result.of_region.assign(map.regions.size(), 0);
      for (std::size_t i = pieces.region.size(); i-- > 0;)
        result.of_region[pieces.region[i]] = result.of_piece[i];
      return result;
    }
  }
  throw Error("no colouring of the regions was found with 18 hues");
}

}  // namespace stope::exports
