// Problem: two cells see what they saw before, but the outline between the two places is another
// now: which cells may a rule judge otherwise?
// Idea: a verdict can only change if the outline changed on the way between the places that the
// rule looks at, now or before. Going along the runs of edges that stayed, from where they end:
// - Whether edges are within the gap can change for edges within the gap of an end.
// - A residual under which places are not divided bounds their way: it is shorter than residual
//   plus chord, and the chord is at most 2 d + 2 if one place is seen from d cells away. The end is
//   on that way, so the nearer one of the two places is at most residual / 2 + d + 1 away from it.
// - Places with no turn between them are on this side of the first turn, seen from the end, or both
//   on a stretch without a turn that is half of the outline.
// - Places come to different outlines, or to one, only if they are on different parts, as runs have
//   it: all but the largest part of each outline cover all such pairs.
// Cost: see the header.
#include "plugins/topology/felt_changes.hpp"

#include <algorithm>
#include <map>
#include <set>

namespace stope::topology {
namespace {

using Kind = ExtractionMethod::Kind;

std::size_t at(std::int64_t place) { return static_cast<std::size_t>(place); }

class FeltEdges {
 public:
  FeltEdges(const NamedOutlines& outlines, const OutlineChange& change)
      : outlines_(outlines), change_(change) {}

  /// Those within so many edges of an end.
  void add_within(std::int32_t reach) {
    for (const StayedRun& run : change_.runs) {
      const std::int32_t count = std::min(reach, run.count);
      add(run, 0, count);
      add(run, run.count - count, run.count);
    }
  }

  void add_by_residual(const DividingRule& rule, const SeenFrom& seen) {
    // A little more than proven, for the sake of rounding.
    const double half = rule.residual() / 2 + 1.01;
    const double farthest = seen.farthest();
    for (const StayedRun& run : change_.runs) {
      if (is_small(run, kSmallOutline) || run.count <= 2 * kWayReach) {
        add(run, 0, run.count);
        continue;
      }
      // Beside an end the shares of the edges are others than before.
      const std::int32_t low = kWayReach, high = run.count - kWayReach;
      const std::int64_t whole = rule.ways().whole[at(run.outline)];
      const auto way = [&](std::int32_t from, std::int32_t to) {
        const std::int64_t way =
            rule.ways().way[at(number(run, to))] - rule.ways().way[at(number(run, from))];
        return static_cast<double>(way < 0 ? way + whole : way) / OutlineWays::kUnit;
      };
      const auto is_felt = [&](std::int32_t i, double from_end) {
        return from_end <= half + seen.farthest(name(run, i));
      };
      add(run, 0, low);
      for (std::int32_t i = low; i < high && way(low, i) <= half + farthest; ++i)
        if (is_felt(i, way(low, i))) add(run, i, i + 1);
      for (std::int32_t i = high; i-- > low && way(i, high) <= half + farthest;)
        if (is_felt(i, way(i, high))) add(run, i, i + 1);
      add(run, high, run.count);
    }
  }

  void add_by_turns(const DividingRule& rule) {
    const std::int32_t reach = reach_of_turns(rule.turn_rule());
    for (const StayedRun& run : change_.runs) {
      if (is_small(run, 4 * reach) || run.count <= 2 * reach) {
        add(run, 0, run.count);
        continue;
      }
      std::vector<std::int32_t> turns{-1};
      for (std::int32_t i = reach; i < run.count - reach; ++i)
        if (rule.turns().turning[at(number(run, i))]) turns.push_back(i);
      turns.push_back(run.count);
      const std::int32_t half = std::min(run.old_outline_count, count_of(run.outline)) / 2;
      for (std::size_t i = 1; i < turns.size(); ++i) {
        const std::int32_t low = turns[i - 1], high = turns[i];
        if (low < 0 || high == run.count || high - low + 2 >= half)
          add(run, std::max(low - 1, 0), std::min(high + 2, run.count));
      }
    }
  }

  /// For all pairs that were of one outline and are of two now, or the other way round, one of
  /// both.
  void add_regrouped() {
    std::map<std::pair<std::int32_t, std::int32_t>, std::int64_t> parts;  // by old, new outline
    for (const StayedRun& run : change_.runs) parts[{run.old_outline, run.outline}] += run.count;
    std::vector<std::pair<std::int64_t, std::pair<std::int32_t, std::int32_t>>> order;
    for (const auto& [part, count] : parts) order.emplace_back(-count, part);
    std::sort(order.begin(), order.end());
    // Of each outline, old or new, at most one part may be left out.
    std::set<std::int32_t> old, now;
    for (const auto& [count, part] : order)
      if (!old.contains(part.first) && !now.contains(part.second)) {
        old.insert(part.first), now.insert(part.second);
        parts[part] = 0;
      }
    for (const StayedRun& run : change_.runs)
      if (parts[{run.old_outline, run.outline}] > 0) add(run, 0, run.count);
  }

  const std::vector<OutlineEdge>& names() const { return names_; }

 private:
  std::int32_t count_of(std::int32_t outline) const {
    return outlines_.by_number.list[at(outline)].count;
  }
  OutlineEdge number(const StayedRun& run, std::int32_t i) const {
    const Outline& whole = outlines_.by_number.list[at(run.outline)];
    const std::int32_t along = run.first + i;
    return whole.first + (along < whole.count ? along : along - whole.count);
  }
  OutlineEdge name(const StayedRun& run, std::int32_t i) const {
    return outlines_.name[at(number(run, i))];
  }
  void add(const StayedRun& run, std::int32_t begin, std::int32_t end) {
    for (std::int32_t i = begin; i < end; ++i) names_.push_back(name(run, i));
  }
  bool is_small(const StayedRun& run, std::int32_t least) const {
    return run.old_outline_count < least || count_of(run.outline) < least;
  }

  const NamedOutlines& outlines_;
  const OutlineChange& change_;
  std::vector<OutlineEdge> names_;
};

}  // namespace

void add_tiles_of_felt_changes(const ExtractionMethod& method, const NamedOutlines& outlines,
                               const DividingRule& rule, const OutlineChange& change,
                               const SeenFrom& seen, TileSet& tiles) {
  FeltEdges felt(outlines, change);
  if (method.kind != Kind::kWatershed) felt.add_within(outlines.by_name.gap);
  if (method.kind == Kind::kWatershed) felt.add_regrouped();
  if (method.kind == Kind::kSkeleton && !method.by_lambda()) felt.add_by_residual(rule, seen);
  if (method.kind == Kind::kWatershedParts) felt.add_by_turns(rule);
  seen.add_tiles(felt.names(), outlines.by_name, tiles);
}

}  // namespace stope::topology
