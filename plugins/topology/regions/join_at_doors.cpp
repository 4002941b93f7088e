// Problem: which basins of the clearance are one room.
// Idea: the doors of the Voronoi diagram are the saddles of the clearance (Thrun 1998): the
// clearest places between two basins. From the clearest saddle down, the basins on both sides
// become one unless the saddle is a door: clearly narrower than both. From a saddle the border
// falls along the steepest descents to both walls, which is the critical line. Pieces of corridors
// are known by their many neighbours, and may narrow more between each other than rooms.
// Cost: linear in the saddles, which are few beside the cells, but for sorting the rooms.
#include "plugins/topology/regions/join_at_doors.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

#include "plugins/topology/disjoint_sets.hpp"
#include "plugins/topology/regions/borders.hpp"

namespace stope::topology {
namespace {

/// Half the free width where the clearance is as given: to the obstacle's edge, not its centre.
double half_width(std::int32_t squared) { return std::sqrt(static_cast<double>(squared)) - 0.5; }

/// Basins that are joined; a set is named by the basin with the clearest peak.
class JoinedBasins {
 public:
  JoinedBasins(const Ground& ground, const std::vector<CellIndex>& peaks)
      : ground_(ground), peaks_(peaks), parent_(peaks.size()) {
    for (std::size_t i = 0; i < parent_.size(); ++i) parent_[i] = static_cast<std::int32_t>(i);
  }
  std::int32_t find(std::int32_t basin) {
    while (parent_[at(basin)] != basin) {
      parent_[at(basin)] = parent_[at(parent_[at(basin)])];
      basin = parent_[at(basin)];
    }
    return basin;
  }
  void join(std::int32_t a, std::int32_t b) {
    if (is_clearer(b, a)) std::swap(a, b);
    parent_[at(b)] = a;
  }
  std::int32_t squared(std::int32_t basin) const { return ground_.squared(peaks_[at(basin)]); }
  bool is_clearer(std::int32_t a, std::int32_t b) const {
    return is_uphill(ground_, peaks_[at(a)], peaks_[at(b)]);
  }

 private:
  static std::size_t at(std::int32_t basin) { return static_cast<std::size_t>(basin); }
  const Ground& ground_;
  const std::vector<CellIndex>& peaks_;
  std::vector<std::int32_t> parent_;
};

/// How two rooms touch.
struct Opening {
  std::int64_t steps = 0;  ///< pairs of cells
  bool wide = false;       ///< has a place wide enough for a way
};

/// Rooms too small to be any join the neighbour they are most open to, one to which there is a way
/// if there is: the region each becomes. Notes the names of those that no way joins.
std::vector<std::int32_t> join_small(RegionSet& set, const TileParts& tiles,
                                     const std::vector<Contact>& contacts, const DoorRule& rule) {
  const auto count = static_cast<std::size_t>(set.count) + 1;
  std::vector<std::int64_t> area(count, 0);
  for (std::size_t tile = 0; tile < tiles.size(); ++tile)
    for (const TilePart& part : tiles.parts(tile))
      area[static_cast<std::size_t>(set.of(part.name))] += part.free_cells;
  std::vector<std::map<std::int32_t, Opening>> open(count);
  for (const Border& border : find_borders(contacts, set)) {
    const Opening opening{border.steps, border.squared >= rule.least_squared};
    open[static_cast<std::size_t>(border.a)][border.b] = opening;
    open[static_cast<std::size_t>(border.b)][border.a] = opening;
  }
  std::vector<std::int32_t> now(count);
  std::vector<std::uint8_t> cut_off(count, 0);
  std::vector<std::pair<std::int64_t, std::int32_t>> order;
  for (std::size_t i = 0; i < count; ++i) {
    now[i] = static_cast<std::int32_t>(i);
    if (i > 0 && static_cast<double>(area[i]) < rule.least_area)
      order.emplace_back(area[i], now[i]);
  }
  std::sort(order.begin(), order.end());
  const auto find = [&](std::int32_t region) {
    while (now[static_cast<std::size_t>(region)] != region)
      region = now[static_cast<std::size_t>(region)];
    return region;
  };
  for (const auto& [cells, region] : order) {
    const auto own = static_cast<std::size_t>(region);
    if (find(region) != region || static_cast<double>(area[own]) >= rule.least_area) continue;
    std::int32_t target = 0;
    Opening widest;
    for (const auto& [other, opening] : open[own])
      if (std::tie(opening.wide, opening.steps) > std::tie(widest.wide, widest.steps))
        target = other, widest = opening;
    if (target == 0) continue;
    if (!widest.wide) cut_off[own] = 1;
    const auto to = static_cast<std::size_t>(target);
    now[own] = target;
    area[to] += area[own];
    for (const auto& [other, opening] : open[own]) {
      const auto there = static_cast<std::size_t>(other);
      open[there].erase(region);
      if (other == target) continue;
      for (Opening* joined : {&open[to][other], &open[there][target]}) {
        joined->steps += opening.steps;
        joined->wide |= opening.wide;
      }
    }
    open[own].clear();
  }
  set.cut_off.assign(set.of_name.size(), 0);
  for (std::size_t name = 0; name < set.of_name.size(); ++name)
    for (std::int32_t at = set.of_name[name]; at != now[static_cast<std::size_t>(at)];
         at = now[static_cast<std::size_t>(at)])
      set.cut_off[name] |= cut_off[static_cast<std::size_t>(at)];
  for (std::size_t i = 1; i < count; ++i) now[i] = find(static_cast<std::int32_t>(i));
  return now;
}

/// The same regions with other numbers: `now` has the one that each has become a part of.
void renumber(RegionSet& set, const std::vector<std::int32_t>& now) {
  std::vector<std::int32_t> number(now.size(), 0);
  set.count = 0;
  for (std::size_t i = 1; i < now.size(); ++i)
    if (now[i] == static_cast<std::int32_t>(i)) number[i] = ++set.count;
  for (std::int32_t& region : set.of_name)
    region = number[static_cast<std::size_t>(now[static_cast<std::size_t>(region)])];
}

/// Hubs that are open to each other become one: the region each becomes.
std::vector<std::int32_t> join_hubs(const Ground& ground, const RegionSet& set,
                                    const std::vector<Contact>& contacts, const DoorRule& rule) {
  constexpr std::int32_t kNeighboursOfHub = 3;
  const auto count = static_cast<std::size_t>(set.count) + 1;
  const std::vector<Border> borders = find_borders(contacts, set);
  std::vector<std::int32_t> neighbours(count, 0), widest(count, 0), now(count);
  for (const Border& border : borders) {
    ++neighbours[static_cast<std::size_t>(border.a)];
    ++neighbours[static_cast<std::size_t>(border.b)];
  }
  for (std::size_t name = 1; name < set.of_name.size(); ++name)
    if (auto& most = widest[static_cast<std::size_t>(set.of_name[name])]; set.of_name[name] != 0)
      most = std::max(most, ground.squared(set.key_of_name[name]));
  DisjointSets joined(count);
  for (const Border& border : borders) {
    const auto a = static_cast<std::size_t>(border.a), b = static_cast<std::size_t>(border.b);
    if (std::min(neighbours[a], neighbours[b]) >= kNeighboursOfHub &&
        border.squared >= rule.least_squared &&
        half_width(border.squared) >= rule.hub_ratio * half_width(std::max(widest[a], widest[b])))
      joined.join(border.a, border.b);
  }
  for (std::size_t i = 0; i < count; ++i) now[i] = joined.find(static_cast<std::int32_t>(i));
  return now;
}

}  // namespace

RegionSet join_at_doors(const Ground& ground, const Basins& basins, const TileParts& tiles,
                        const std::vector<Contact>& contacts, const DoorRule& rule,
                        const Checkpoint& checkpoint) {
  const std::vector<CellIndex>& peaks = basins.peaks();
  JoinedBasins joined(ground, peaks);
  checkpoint();
  for (const Contact& contact : contacts) {
    const std::int32_t a = joined.find(contact.a), b = joined.find(contact.b);
    if (a == b) continue;
    const double first = half_width(joined.squared(a)), second = half_width(joined.squared(b));
    const double saddle = half_width(contact.squared);
    const bool narrow = contact.squared < rule.least_squared &&
                        std::min(joined.squared(a), joined.squared(b)) >= rule.least_squared;
    const bool door = saddle <= rule.door_ratio * std::min(first, second) &&
                      saddle <= rule.similar_ratio * std::sqrt(first * second);
    if (!narrow && !door) joined.join(a, b);
  }
  checkpoint();
  std::vector<std::int32_t> rooms;
  for (std::size_t i = 1; i < peaks.size(); ++i)
    if (const auto basin = static_cast<std::int32_t>(i);
        peaks[i] != 0 && joined.find(basin) == basin)
      rooms.push_back(basin);
  std::sort(rooms.begin(), rooms.end(),
            [&](std::int32_t a, std::int32_t b) { return joined.is_clearer(a, b); });
  RegionSet set;
  set.key_of_name = peaks;
  set.of_name.assign(peaks.size(), 0);
  for (const std::int32_t room : rooms) set.of_name[static_cast<std::size_t>(room)] = ++set.count;
  for (std::size_t i = 1; i < peaks.size(); ++i)
    if (peaks[i] != 0)
      set.of_name[i] =
          set.of_name[static_cast<std::size_t>(joined.find(static_cast<std::int32_t>(i)))];
  renumber(set, join_small(set, tiles, contacts, rule));
  if (rule.hub_ratio < 1) renumber(set, join_hubs(ground, set, contacts, rule));
  return set;
}

}  // namespace stope::topology
