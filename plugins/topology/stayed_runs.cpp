#include "plugins/topology/stayed_runs.hpp"

namespace stope::topology {
namespace {

std::size_t at(std::int64_t place) { return static_cast<std::size_t>(place); }

/// Whether one number came right behind another.
bool follows(OutlineEdge first, OutlineEdge second, const Outlines& by_number) {
  if (first < 0 || second < 0) return false;
  if (second == first + 1) return true;
  const Outline& whole = by_number.list[at(by_number.of_edge[at(first)])];
  return second == whole.first && first == whole.first + whole.count - 1;
}

/// What a ring is made of: pieces that begin at its breaks, counted on beyond the last one.
class Pieces {
 public:
  Pieces(const OutlineRing& ring, const NamedOutlines& outlines)
      : ring_(ring), outlines_(outlines) {}

  std::size_t count() const { return ring_.breaks.size(); }
  std::size_t begin_of(std::size_t piece) const {
    const std::size_t rounds = piece / count();
    return at(ring_.breaks[piece % count()]) + rounds * ring_.names.size();
  }
  OutlineEdge old_number(std::size_t place) const {
    return outlines_.number[at(ring_.names[place % ring_.names.size()])];
  }
  /// Whether its first edge came right behind the last one of the piece before it.
  bool goes_on(std::size_t piece) const {
    const std::size_t begin = begin_of(piece);
    return follows(old_number(begin + ring_.names.size() - 1), old_number(begin),
                   outlines_.by_number);
  }
  /// The first one that did not, or their count.
  std::size_t first_break() const {
    std::size_t first = 0;
    while (first < count() && goes_on(first)) ++first;
    return first;
  }

 private:
  const OutlineRing& ring_;
  const NamedOutlines& outlines_;
};

/// Those of one ring. Such a run can only end at a break.
void add_runs(const OutlineRing& ring, std::int32_t place, const NamedOutlines& outlines,
              std::vector<StayedRun>& runs) {
  const Pieces pieces(ring, outlines);
  const std::size_t count = ring.names.size(), first = pieces.first_break();
  if (first == pieces.count()) return;
  for (std::size_t piece = first; piece < first + pieces.count();) {
    const std::size_t begin = pieces.begin_of(piece);
    do ++piece;
    while (piece < first + pieces.count() && pieces.goes_on(piece));
    const OutlineEdge number = pieces.old_number(begin);
    if (number < 0) continue;
    StayedRun run;
    run.outline = place;
    run.first = static_cast<std::int32_t>((begin + count - ring.start) % count);
    run.count = static_cast<std::int32_t>(pieces.begin_of(piece) - begin);
    run.old_outline = outlines.by_number.of_edge[at(number)];
    const Outline& old = outlines.by_number.list[at(run.old_outline)];
    run.old_first = number - old.first;
    run.old_outline_count = old.count;
    run.old_outline_first = old.first;
    runs.push_back(run);
  }
}

}  // namespace

bool stays(const OutlineRing& ring, const NamedOutlines& outlines) {
  const Pieces pieces(ring, outlines);
  return pieces.first_break() == pieces.count();
}

std::vector<StayedRun> find_stayed_runs(const std::vector<OutlineRing>& rings,
                                        const NamedOutlines& outlines) {
  std::vector<StayedRun> runs;
  for (std::size_t i = 0; i < rings.size(); ++i)
    add_runs(rings[i], static_cast<std::int32_t>(i), outlines, runs);
  return runs;
}

}  // namespace stope::topology
