#include "plugins/planner/rest_network.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace stope::planner {

RestNetwork rest_of(const NodeContraction& contraction, std::span<const NodePlace> places,
                    std::span<const std::uint32_t> taken) {
  constexpr std::uint32_t kGone = std::numeric_limits<std::uint32_t>::max();
  RestNetwork rest;
  rest.number_of.assign(places.size(), 0);
  for (const std::uint32_t node : taken) rest.number_of[node] = kGone;
  for (std::uint32_t node = 0; node < places.size(); ++node) {
    if (rest.number_of[node] == kGone) continue;
    rest.number_of[node] = static_cast<std::uint32_t>(rest.nodes.size());
    rest.nodes.push_back(node);
    rest.places.push_back(places[node]);
  }
  auto& [first, near] = rest.neighbours;
  first.push_back(0);
  for (const std::uint32_t node : rest.nodes) {
    const auto begin = static_cast<std::ptrdiff_t>(near.size());
    for (const auto* links : {&contraction.links_from(node), &contraction.links_to(node)})
      for (const auto& link : *links) near.push_back(rest.number_of[link.other]);
    std::sort(near.begin() + begin, near.end());
    near.erase(std::unique(near.begin() + begin, near.end()), near.end());
    first.push_back(static_cast<std::uint32_t>(near.size()));
  }
  return rest;
}

bool is_grid_like(const RestNetwork& rest) {
  constexpr double kWide = 0.6;  // a grid has 1, road networks less the larger they are
  const auto crossing = static_cast<double>(least_crossing(rest.neighbours, rest.places));
  return crossing > kWide * std::sqrt(static_cast<double>(rest.nodes.size()));
}

}  // namespace stope::planner
