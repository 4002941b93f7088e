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

/// Lets lines that came out as they were keep their courses, and with them all that was made of
/// these. Both are in order.
void keep_courses(const std::vector<TracedLine>& old, std::vector<TracedLine>& lines,
                  const Courses& courses) {
  auto before = old.begin();
  for (TracedLine& line : lines) {
    while (before != old.end() && comes_first(*before, line)) ++before;
    if (before == old.end()) return;
    if (comes_first(line, *before)) continue;
    const CourseView was = courses.view(before->course), is = courses.view(line.course);
    if (was.size() != is.size()) continue;
    std::size_t same = 0;
    while (same < is.size() && was[same] == is[same]) ++same;
    if (same == is.size()) line.course = before->course;
  }
}

}  // namespace

LineStore::LineStore(std::vector<TracedLine> lines, const TileSet& tiles) : at_tile_(tiles.size()) {
  for (TracedLine& line : lines) entries_.push_back(enter(std::move(line), tiles));
  put_nodes_in_order();
}

std::unique_ptr<LineStore::Entry> LineStore::enter(TracedLine line, const TileSet& tiles) {
  auto entry = std::make_unique<Entry>();
  entry->line = std::move(line);
  entry->from = node_at(entry->line.from());
  entry->to = node_at(entry->line.to());
  for (const CellIndex corner : entry->line.corners) {
    const std::int32_t tile = tiles.tile_of(corner);
    if (entry->tiles.empty() || entry->tiles.back() != tile) entry->tiles.push_back(tile);
  }
  std::sort(entry->tiles.begin(), entry->tiles.end());
  entry->tiles.erase(std::unique(entry->tiles.begin(), entry->tiles.end()), entry->tiles.end());
  for (const std::int32_t tile : entry->tiles) at_tile_[at(tile)].push_back(entry.get());
  return entry;
}

std::int32_t LineStore::node_at(CellIndex corner) {
  const auto [known, is_new] = node_of_corner_.try_emplace(corner, -1);
  if (is_new) {
    if (unused_nodes_.empty()) {
      unused_nodes_.push_back(static_cast<std::int32_t>(nodes_.size()));
      nodes_.emplace_back();
    }
    known->second = unused_nodes_.back();
    unused_nodes_.pop_back();
    nodes_[at(known->second)] = {corner, 0, 0};
    new_nodes_.push_back(known->second);
  }
  ++nodes_[at(known->second)].lines;
  return known->second;
}

void LineStore::leave(std::int32_t node) {
  if (--nodes_[at(node)].lines == 0) node_of_corner_.erase(nodes_[at(node)].corner);
}

void LineStore::put_nodes_in_order() {
  const auto comes_first = [&](std::int32_t a, std::int32_t b) {
    return nodes_[at(a)].corner < nodes_[at(b)].corner;
  };
  std::sort(new_nodes_.begin(), new_nodes_.end(), comes_first);
  const auto before = static_cast<std::ptrdiff_t>(nodes_in_order_.size());
  nodes_in_order_.insert(nodes_in_order_.end(), new_nodes_.begin(), new_nodes_.end());
  std::inplace_merge(nodes_in_order_.begin(), nodes_in_order_.begin() + before,
                     nodes_in_order_.end(), comes_first);
  new_nodes_.clear();
  for (std::size_t i = 0; i < nodes_in_order_.size(); ++i)
    nodes_[at(nodes_in_order_[i])].rank = static_cast<std::int32_t>(i);
}

void LineStore::update(LineTracer& tracer, const FreeSpace& space, const TileSet& tiles,
                       const Courses& courses) {
  std::vector<Entry*> gone;
  for (const std::int32_t tile : tiles.list()) {
    for (Entry* entry : at_tile_[at(tile)]) {
      if (entry->gone) continue;
      entry->gone = true;
      gone.push_back(entry);
    }
  }
  std::vector<TracedLine> old;
  for (Entry* entry : gone) {
    tracer.forget(entry->line);
    leave(entry->from);
    leave(entry->to);
    for (const std::int32_t tile : entry->tiles)
      std::erase_if(at_tile_[at(tile)], [](const Entry* other) { return other->gone; });
    old.push_back(std::move(entry->line));
  }
  std::erase_if(entries_, [](const auto& entry) { return entry->gone; });
  std::erase_if(nodes_in_order_, [&](std::int32_t node) {
    if (nodes_[at(node)].lines > 0) return false;
    unused_nodes_.push_back(node);
    return true;
  });
  std::vector<CellIndex> corners;
  for (const std::int32_t tile : tiles.list()) find_corners(space, tiles, tile, corners);
  std::vector<TracedLine> lines;
  tracer.trace(corners, lines);
  const auto before = static_cast<std::ptrdiff_t>(entries_.size());
  std::sort(lines.begin(), lines.end(), comes_first);
  std::sort(old.begin(), old.end(), comes_first);
  keep_courses(old, lines, courses);
  for (TracedLine& line : lines) entries_.push_back(enter(std::move(line), tiles));
  std::inplace_merge(entries_.begin(), entries_.begin() + before, entries_.end(),
                     [](const auto& a, const auto& b) { return comes_first(a->line, b->line); });
  put_nodes_in_order();
}

LineEnds LineStore::ends() const {
  LineEnds ends;
  ends.corner.reserve(nodes_in_order_.size());
  ends.of_line.reserve(entries_.size());
  for (const std::int32_t node : nodes_in_order_) ends.corner.push_back(nodes_[at(node)].corner);
  for (const auto& entry : entries_)
    ends.of_line.emplace_back(nodes_[at(entry->from)].rank, nodes_[at(entry->to)].rank);
  return ends;
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
