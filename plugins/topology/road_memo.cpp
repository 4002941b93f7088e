#include "plugins/topology/road_memo.hpp"

#include <algorithm>
#include <cmath>

namespace stope::topology {

const FinishedRoad* RoadMemo::find(std::int64_t name) {
  const auto entry = entries_.find(name);
  if (entry == entries_.end()) return nullptr;
  entry->second.used = true;
  return &entry->second.road;
}

const FinishedRoad& RoadMemo::add(std::int64_t name, FinishedRoad road, const LookedAt& looked_at) {
  Entry entry{std::move(road), {}, {}, true};
  const auto add_tile = [&](CellIndex cell, std::vector<std::int32_t>& tiles) {
    const std::int32_t tile = tiles_->tile_of(cell);
    if (tiles.empty() || tiles.back() != tile) tiles.push_back(tile);
  };
  for (const LinePoint& place : looked_at.places) {
    const auto column = static_cast<std::int32_t>(std::floor(place.x));
    const auto row = static_cast<std::int32_t>(std::floor(place.y));
    add_tile((row + 1) * stride_ + column + 1, entry.tiles);
  }
  for (const CellIndex cell : looked_at.probed) add_tile(cell, entry.probed);
  for (std::vector<std::int32_t>* tiles : {&entry.tiles, &entry.probed}) {
    std::sort(tiles->begin(), tiles->end());
    tiles->erase(std::unique(tiles->begin(), tiles->end()), tiles->end());
  }
  return entries_.insert_or_assign(name, std::move(entry)).first->second.road;
}

void RoadMemo::forget(const TileSet& tiles, const TileSet& flipped) {
  const auto any_in = [](const std::vector<std::int32_t>& places, const TileSet& set) {
    return std::any_of(places.begin(), places.end(),
                       [&](std::int32_t tile) { return set.has(tile); });
  };
  for (auto named = entries_.begin(); named != entries_.end();) {
    Entry& entry = named->second;
    const bool stale = !entry.used || any_in(entry.tiles, tiles) || any_in(entry.probed, flipped);
    entry.used = false;
    named = stale ? entries_.erase(named) : std::next(named);
  }
}

}  // namespace stope::topology
