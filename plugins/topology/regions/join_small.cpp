#include "plugins/topology/regions/join_small.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

#include "plugins/topology/regions/borders.hpp"
#include "plugins/topology/regions/neighbour_lists.hpp"

namespace stope::topology {
namespace {

/// How two regions touch.
struct Opening {
  std::int64_t steps = 0;  ///< pairs of cells
  bool wide = false;       ///< has a place wide enough for a way
};

}  // namespace

void join_small(RegionSet& set, const TileParts& tiles, const std::vector<Contact>& contacts,
                double least_area, std::int32_t least_squared) {
  const auto count = static_cast<std::size_t>(set.count) + 1;
  std::vector<std::int64_t> area(count, 0);
  for (std::size_t name = 0; name < set.of_name.size(); ++name)
    area[static_cast<std::size_t>(set.of_name[name])] +=
        tiles.free_cells_of(static_cast<std::int32_t>(name));
  NeighbourLists<Opening> open(count);
  for (const Border& border : find_borders(contacts, set)) {
    const Opening opening{border.steps, border.squared >= least_squared};
    open.add(border.a, border.b, opening);
    open.add(border.b, border.a, opening);
  }
  std::vector<std::int32_t> now(count);
  std::vector<std::uint8_t> cut_off(count, 0);
  std::vector<std::pair<std::int64_t, std::int32_t>> order;
  for (std::size_t i = 0; i < count; ++i) {
    now[i] = static_cast<std::int32_t>(i);
    if (i > 0 && static_cast<double>(area[i]) < least_area) order.emplace_back(area[i], now[i]);
  }
  std::sort(order.begin(), order.end());
  const auto find = [&](std::int32_t region) {
    while (now[static_cast<std::size_t>(region)] != region)
      region = now[static_cast<std::size_t>(region)];
    return region;
  };
  for (const auto& [cells, region] : order) {
    const auto own = static_cast<std::size_t>(region);
    if (find(region) != region || static_cast<double>(area[own]) >= least_area) continue;
    std::int32_t target = 0;
    Opening widest;
    for (const auto& [other, opening] : open.of(region)) {
      const auto now_is = std::tie(opening.wide, opening.steps);
      const auto was = std::tie(widest.wide, widest.steps);
      if (now_is > was || (now_is == was && other < target)) target = other, widest = opening;
    }
    if (target == 0) continue;
    if (!widest.wide) cut_off[own] = 1;
    now[own] = target;
    area[static_cast<std::size_t>(target)] += area[own];
    open.join(region, target, [](Opening& joined, const Opening& opening) {
      joined.steps += opening.steps;
      joined.wide |= opening.wide;
    });
  }
  set.cut_off.assign(set.of_name.size(), 0);
  for (std::size_t name = 0; name < set.of_name.size(); ++name)
    for (std::int32_t at = set.of_name[name]; at != now[static_cast<std::size_t>(at)];
         at = now[static_cast<std::size_t>(at)])
      set.cut_off[name] |= cut_off[static_cast<std::size_t>(at)];
  for (std::size_t i = 1; i < count; ++i) now[i] = find(static_cast<std::int32_t>(i));
  renumber(set, now);
}

void renumber(RegionSet& set, const std::vector<std::int32_t>& now) {
  std::vector<std::int32_t> number(now.size(), 0);
  set.count = 0;
  for (std::size_t i = 1; i < now.size(); ++i)
    if (now[i] == static_cast<std::int32_t>(i)) number[i] = ++set.count;
  for (std::int32_t& region : set.of_name)
    region = number[static_cast<std::size_t>(now[static_cast<std::size_t>(region)])];
}

}  // namespace stope::topology
