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

const FinishedRoad& RoadMemo::add(std::int64_t name, FinishedRoad road,
                                  const std::vector<LinePoint>& places) {
  Entry entry{std::move(road), {}, true};
  for (const LinePoint& place : places) {
    const auto column = static_cast<std::int32_t>(std::floor(place.x));
    const auto row = static_cast<std::int32_t>(std::floor(place.y));
    const std::int32_t tile = tiles_->tile_of((row + 1) * stride_ + column + 1);
    if (entry.tiles.empty() || entry.tiles.back() != tile) entry.tiles.push_back(tile);
  }
  return entries_.insert_or_assign(name, std::move(entry)).first->second.road;
}

void RoadMemo::forget(const TileSet& tiles) {
  for (auto named = entries_.begin(); named != entries_.end();) {
    Entry& entry = named->second;
    const bool stale =
        !entry.used || std::any_of(entry.tiles.begin(), entry.tiles.end(),
                                   [&](std::int32_t tile) { return tiles.has(tile); });
    entry.used = false;
    named = stale ? entries_.erase(named) : std::next(named);
  }
}

}  // namespace stope::topology
