// Problem: number the boundary between obstacles and free space so that the distance of two
// boundary places along it is a subtraction.
// Idea: look for a free cell below an obstacle, eight cells at a time; a side that has no number
// yet starts a new outline, walked with the obstacle on the left until it closes. Rows are looked
// at from the bottom, so an obstacle's outer outline is met before those of pockets it encloses,
// and an obstacle too small to count is erased as soon as its area is known.
// Cost: one pass over the cells, plus the outlines' length.
#include "plugins/topology/outlines.hpp"

#include <bit>
#include <cstring>

namespace stope::topology {
namespace {

constexpr std::size_t kEdgesBetweenCheckpoints = 1024;

class Tracer {
 public:
  Tracer(FreeSpace& space, EdgeGrid& edges, double least_area, Outlines& outlines,
         const Checkpoint& checkpoint)
      : space_(space),
        edges_(edges),
        least_area_(least_area),
        outlines_(outlines),
        checkpoint_(checkpoint),
        step_{1, space.stride(), -1, -space.stride()} {}

  /// Starts at the southern side of an obstacle cell.
  void start_below(CellIndex cell) {
    if (!(space_[cell] & kObstacle) || (space_[cell - space_.stride()] & kObstacle)) return;
    if ((space_[cell] & kOnOutline) && sides_of(cell)[kSouth] >= 0) return;
    if (walk(cell) && area_ > 0 && static_cast<double>(area_) < least_area_) erase(cell);
  }

 private:
  std::array<OutlineEdge, 4>& sides_of(CellIndex cell) {
    return outlines_.sides[static_cast<std::size_t>(edges_[cell])];
  }

  void number(CellIndex cell, int side) {
    if (!(space_[cell] & kOnOutline)) {
      space_[cell] |= kOnOutline;
      edges_[cell] = static_cast<std::int32_t>(outlines_.sides.size());
      outlines_.sides.push_back({-1, -1, -1, -1});
    }
    sides_of(cell)[static_cast<std::size_t>(side)] =
        static_cast<OutlineEdge>(outlines_.place.size());
    outlines_.place.push_back({column_, row_});
    outlines_.of_edge.push_back(static_cast<std::int32_t>(outlines_.list.size()));
  }

  bool walk(const CellIndex first) {
    Outline outline;
    outline.first = static_cast<OutlineEdge>(outlines_.place.size());
    first_cell_ = outlines_.sides.size();
    column_ = outline.left = outline.right = space_.column(first);
    row_ = outline.bottom = outline.top = space_.row(first);
    area_ = 0;
    CellIndex cell = first;
    int side = kSouth;
    do {
      number(cell, side);
      // An outline can lead all over the map, through memory that nobody has touched yet.
      if (outlines_.place.size() % kEdgesBetweenCheckpoints == 0) checkpoint_();
      // Area by Green: x dy along the sides walked northwards and southwards.
      if (side == kEast) area_ += column_ + 1;
      if (side == kWest) area_ -= column_;
      const int ahead = (side + 1) % 4;
      const CellIndex left_ahead = cell + step_[ahead];
      const CellIndex right_ahead = left_ahead + step_[side];
      if (!(space_[left_ahead] & kObstacle)) {
        side = ahead;
        continue;
      }
      move(ahead);
      cell = left_ahead;
      if (space_[right_ahead] & kObstacle) {
        move(side);
        cell = right_ahead;
        side = (ahead + 2) % 4;
      }
      outline.left = std::min(outline.left, column_);
      outline.right = std::max(outline.right, column_);
      outline.bottom = std::min(outline.bottom, row_);
      outline.top = std::max(outline.top, row_);
    } while (cell != first || side != kSouth);
    outline.count = static_cast<std::int32_t>(outlines_.place.size()) - outline.first;
    outlines_.list.push_back(outline);
    // Numbers in between stay unused, so that a small difference proves one outline.
    const std::size_t next = outlines_.place.size() + static_cast<std::size_t>(outlines_.gap);
    outlines_.place.resize(next);
    outlines_.of_edge.resize(next, -1);
    return true;
  }

  void move(int direction) {
    if (direction == kEast) ++column_;
    if (direction == kWest) --column_;
    if (direction == kNorth) ++row_;
    if (direction == kSouth) --row_;
  }

  void erase(CellIndex first) {
    const auto kept = static_cast<std::size_t>(outlines_.list.back().first);
    outlines_.place.resize(kept);
    outlines_.of_edge.resize(kept);
    // An obstacle's outer outline is walked first, so that all its cells were new.
    outlines_.sides.resize(first_cell_);
    outlines_.list.pop_back();
    std::vector<CellIndex> open{first};
    space_[first] = 0;
    while (!open.empty()) {
      const CellIndex cell = open.back();
      open.pop_back();
      for (const CellIndex step : step_) {
        if (!(space_[cell + step] & kObstacle)) continue;
        space_[cell + step] = 0;
        open.push_back(cell + step);
      }
    }
  }

  FreeSpace& space_;
  EdgeGrid& edges_;
  double least_area_;
  Outlines& outlines_;
  const Checkpoint& checkpoint_;
  std::array<CellIndex, 4> step_;
  std::int32_t column_ = 0, row_ = 0;
  std::int64_t area_ = 0;
  std::size_t first_cell_ = 0;  ///< of the outline walked last, in Outlines::sides
};

}  // namespace

Outlines trace_outlines(FreeSpace& space, EdgeGrid& edges, double least_area, std::int32_t gap,
                        const Checkpoint& checkpoint) {
  constexpr std::uint64_t kObstacles = 0x0101010101010101ULL * kObstacle;
  Outlines outlines;
  outlines.gap = gap;
  Tracer tracer(space, edges, least_area, outlines, checkpoint);
  const CellIndex stride = space.stride();
  for (std::int32_t row = 1; row <= space.height(); ++row) {
    if (row % kRowsBetweenCheckpoints == 0) checkpoint();
    const CellIndex begin = space.index(0, row), end = begin + space.width();
    CellIndex cell = begin;
    for (; cell + 8 <= end; cell += 8) {
      std::uint64_t here = 0, below = 0;
      std::memcpy(&here, space.data() + cell, 8);
      std::memcpy(&below, space.data() + cell - stride, 8);
      for (std::uint64_t hits = here & ~below & kObstacles; hits; hits &= hits - 1)
        tracer.start_below(cell + std::countr_zero(hits) / 8);
    }
    for (; cell < end; ++cell) tracer.start_below(cell);
  }
  return outlines;
}

}  // namespace stope::topology
