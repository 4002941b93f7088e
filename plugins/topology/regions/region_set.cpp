#include "plugins/topology/regions/region_set.hpp"

#include <algorithm>

namespace stope::topology {

std::vector<std::int32_t> RegionParts::tiles_of(const TileParts& tiles, std::size_t region) const {
  std::vector<std::int32_t> all;
  for (const std::int32_t name : names[region]) {
    const auto own = tiles.tiles_of(name);
    all.insert(all.end(), own.begin(), own.end());
  }
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

RegionParts parts_of_regions(const TileParts& tiles, const RegionSet& set) {
  RegionParts parts;
  const auto count = static_cast<std::size_t>(set.count);
  parts.names.resize(count);
  parts.members.resize(count);
  parts.cut_off.resize(count);
  parts.free_cells.resize(count, 0);
  for (std::size_t i = 0; i < set.of_name.size(); ++i) {
    if (set.of_name[i] == 0) continue;
    const auto name = static_cast<std::int32_t>(i);
    const auto place = static_cast<std::size_t>(set.of_name[i]) - 1;
    parts.names[place].push_back(name);
    parts.members[place].push_back(set.key_of_name[i]);
    parts.free_cells[place] += tiles.free_cells_of(name);
    if (set.is_cut_off(name)) parts.cut_off[place].push_back(set.key_of_name[i]);
  }
  for (auto& members : parts.members) std::sort(members.begin(), members.end());
  for (auto& members : parts.cut_off) std::sort(members.begin(), members.end());
  return parts;
}

}  // namespace stope::topology
