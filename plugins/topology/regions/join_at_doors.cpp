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
#include <utility>

#include "plugins/topology/disjoint_sets.hpp"
#include "plugins/topology/regions/borders.hpp"
#include "plugins/topology/regions/join_small.hpp"

namespace stope::topology {
namespace {

/// Half the free width where the clearance is as given: to the obstacle's edge, not its centre.
double half_width(std::int32_t squared) { return std::sqrt(static_cast<double>(squared)) - 0.5; }

/// Basins that are joined; a set is named by the basin with the clearest peak.
class JoinedBasins {
 public:
  JoinedBasins(const Ground& ground, const std::vector<CellIndex>& peaks)
      : peaks_(peaks), squared_(peaks.size()), parent_(peaks.size()) {
    for (std::size_t i = 0; i < parent_.size(); ++i) {
      parent_[i] = static_cast<std::int32_t>(i);
      squared_[i] = ground.squared(peaks[i]);
    }
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
  std::int32_t squared(std::int32_t basin) const { return squared_[at(basin)]; }
  bool is_clearer(std::int32_t a, std::int32_t b) const {
    // As is_uphill.
    return squared(a) != squared(b) ? squared(a) > squared(b) : peaks_[at(a)] < peaks_[at(b)];
  }

 private:
  static std::size_t at(std::int32_t basin) { return static_cast<std::size_t>(basin); }
  const std::vector<CellIndex>& peaks_;
  std::vector<std::int32_t> squared_;  ///< at the peaks, side by side: they are asked for often
  std::vector<std::int32_t> parent_;
};

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
  join_small(set, tiles, contacts, rule.least_area, rule.least_squared);
  if (rule.hub_ratio < 1) renumber(set, join_hubs(ground, set, contacts, rule));
  return set;
}

}  // namespace stope::topology
