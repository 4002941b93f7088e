#include "plugins/topology/road_memo.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace stope::topology {

std::uint64_t RoadMemo::key_of(const std::vector<LinePoint>& points) {
  std::uint64_t key = points.size();
  for (const double number : {points.front().x, points.front().y, points.back().x, points.back().y,
                              points[points.size() / 2].x, points[points.size() / 2].y})
    key = (key ^ std::bit_cast<std::uint64_t>(number)) * 0x9E3779B97F4A7C15ULL;
  return key;
}

const FinishedRoad* RoadMemo::find(const std::vector<LinePoint>& points) {
  const auto [begin, end] = entries_.equal_range(key_of(points));
  for (auto entry = begin; entry != end; ++entry) {
    if (entry->second.points != points) continue;
    entry->second.used = true;
    return &entry->second.road;
  }
  return nullptr;
}

const FinishedRoad& RoadMemo::add(const std::vector<LinePoint>& points, FinishedRoad road,
                                  const std::vector<LinePoint>& places) {
  Entry entry{points, std::move(road), {}};
  for (const LinePoint& place : places) {
    const auto column = static_cast<std::int32_t>(std::floor(place.x));
    const auto row = static_cast<std::int32_t>(std::floor(place.y));
    const std::int32_t tile = tiles_->tile_of((row + 1) * stride_ + column + 1);
    if (entry.tiles.empty() || entry.tiles.back() != tile) entry.tiles.push_back(tile);
  }
  return entries_.emplace(key_of(points), std::move(entry))->second.road;
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
