#include "plugins/topology/line_store.hpp"

#include <algorithm>
#include <cstring>

namespace stope::topology {
namespace {

std::size_t at(std::int32_t place) { return static_cast<std::size_t>(place); }

/// The corners of a tile that dividing lines pass.
void find_corners(const FreeSpace& space, const TileSet& tiles, std::int32_t tile,
                  std::vector<CellIndex>& corners) {
  constexpr int kDivided = kDividedEast | kDividedNorth;
  const CellIndex stride = space.stride();
  tiles.for_each_row(tile, [&](CellIndex first, std::int32_t count) {
    const CellIndex last = static_cast<CellIndex>(space.size()) - stride;
    for (CellIndex cell = first; cell < std::min(first + count, last); ++cell) {
      const bool passed = (space[cell] & kDivided) || (space[cell + stride] & kDividedEast) ||
                          (space[cell + 1] & kDividedNorth);
      if (passed) corners.push_back(cell);
    }
  });
}

}  // namespace

LineStore::LineStore(std::vector<TracedLine> lines, const TileSet& tiles) : at_tile_(tiles.size()) {
  for (TracedLine& line : lines) entries_.push_back(enter(std::move(line), tiles));
}

std::unique_ptr<LineStore::Entry> LineStore::enter(TracedLine line, const TileSet& tiles) {
  auto entry = std::make_unique<Entry>();
  entry->line = std::move(line);
  for (const CellIndex corner : entry->line.corners) {
    const std::int32_t tile = tiles.tile_of(corner);
    if (entry->tiles.empty() || entry->tiles.back() != tile) entry->tiles.push_back(tile);
  }
  std::sort(entry->tiles.begin(), entry->tiles.end());
  entry->tiles.erase(std::unique(entry->tiles.begin(), entry->tiles.end()), entry->tiles.end());
  for (const std::int32_t tile : entry->tiles) at_tile_[at(tile)].push_back(entry.get());
  return entry;
}

void LineStore::update(LineTracer& tracer, const FreeSpace& space, const TileSet& tiles) {
  std::vector<Entry*> gone;
  for (const std::int32_t tile : tiles.list()) {
    for (Entry* entry : at_tile_[at(tile)]) {
      if (entry->gone) continue;
      entry->gone = true;
      gone.push_back(entry);
    }
  }
  for (const Entry* entry : gone) {
    tracer.forget(entry->line);
    for (const std::int32_t tile : entry->tiles)
      std::erase_if(at_tile_[at(tile)], [](const Entry* other) { return other->gone; });
  }
  std::erase_if(entries_, [](const auto& entry) { return entry->gone; });
  std::vector<CellIndex> corners;
  for (const std::int32_t tile : tiles.list()) find_corners(space, tiles, tile, corners);
  std::vector<TracedLine> lines;
  tracer.trace(corners, lines);
  const auto before = static_cast<std::ptrdiff_t>(entries_.size());
  std::sort(lines.begin(), lines.end(), comes_first);
  for (TracedLine& line : lines) entries_.push_back(enter(std::move(line), tiles));
  std::inplace_merge(entries_.begin(), entries_.begin() + before, entries_.end(),
                     [](const auto& a, const auto& b) { return comes_first(a->line, b->line); });
}

std::vector<const TracedLine*> LineStore::list() const {
  std::vector<const TracedLine*> list;
  list.reserve(entries_.size());
  for (const auto& entry : entries_) list.push_back(&entry->line);
  return list;
}

std::vector<CourseId> LineStore::courses() const {
  std::vector<CourseId> courses;
  courses.reserve(entries_.size());
  for (const auto& entry : entries_) courses.push_back(entry->line.course);
  return courses;
}

}  // namespace stope::topology
