// Problem: an outline is a staircase of cell sides; say where it really turns, and say it again
// when a few of its edges have changed.
// Idea: a side's heading is a right angle, so mean headings of windows are differences of sums of
// whole numbers, the same ones wherever the sums begin. An edge's window is short, so edges that
// stayed and are far enough from those that did not turn as before.
// Cost: see the header.
#include "plugins/topology/outline_turns.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "plugins/topology/outline_shape.hpp"

namespace stope::topology {
namespace {

std::size_t at(std::int64_t place) { return static_cast<std::size_t>(place); }

/// Edges before and behind an edge at which headings are compared, and over how many to either
/// side of these they are averaged.
struct TurnWindow {
  std::int64_t half, reach;
};

/// A part of the length, in edges.
std::int64_t half_of(const TurnRule& rule, double part) {
  return std::llround(part * std::min(rule.length, 1e9));
}

TurnWindow window_of(std::int64_t half) { return {half, half / 4}; }

/// Looks for the turns of one outline.
class TurnFinder {
 public:
  TurnFinder(const Outline& outline, const std::uint8_t* sides, const TurnRule& rule,
             std::uint8_t* turning)
      : count_(outline.count),
        sides_(sides),
        least_(rule.angle / (std::numbers::pi / 2) - 1e-9),
        turning_(turning) {
    for (const double part : {0.5, 0.25, 0.125}) {
      const TurnWindow window = window_of(std::min<std::int64_t>(half_of(rule, part), count_ / 4));
      if (window.half < 2) continue;
      windows_.push_back(window);
      around_ = std::max(around_, window.half + window.reach + 1);
    }
  }

  /// Marks those among the outline's edges from `begin` to before `end`.
  void mark(std::int64_t begin, std::int64_t end) {
    std::fill(turning_ + begin, turning_ + end, std::uint8_t{0});
    sum_headings(begin, end);
    for (const TurnWindow& window : windows_) mark(window, turning_ + begin, end - begin);
  }

 private:
  /// Headings are in right turns since any edge; they are summed from `around_` edges before
  /// `begin` to as many behind `end`.
  void sum_headings(std::int64_t begin, std::int64_t end) {
    sums_.clear();
    sums_.reserve(at(end - begin + 2 * around_ + 1));
    std::int64_t edge = (begin - around_) % count_, heading = 0, sum = 0;
    if (edge < 0) edge += count_;
    int side = sides_[edge];
    sums_.push_back(0);
    for (std::int64_t left = end - begin + 2 * around_; left > 0; --left) {
      const int next = sides_[edge];
      const int turn = (side - next + 4) % 4;
      heading += turn == 3 ? -1 : turn;
      sums_.push_back(sum += heading);
      side = next;
      if (++edge == count_) edge = 0;
    }
  }

  void mark(const TurnWindow& window, std::uint8_t* turning, std::int64_t count) const {
    // Sums over so many headings differ by at least that many times the angle.
    const auto least =
        static_cast<std::int64_t>(std::ceil(least_ * static_cast<double>(2 * window.reach + 1)));
    const std::int64_t* sums = sums_.data() + around_;
    const std::int64_t *behind = sums + window.half, *before = sums - window.half;
    const std::int64_t last = window.reach + 1, first = -window.reach;
    for (std::int64_t i = 0; i < count; ++i) {
      const std::int64_t turned =
          (behind[i + last] - behind[i + first]) - (before[i + last] - before[i + first]);
      turning[i] |= static_cast<std::uint8_t>(turned >= least);
    }
  }

  std::int64_t count_, around_ = 0;
  const std::uint8_t* sides_;
  double least_;
  std::uint8_t* turning_;
  std::vector<TurnWindow> windows_;
  std::vector<std::int64_t> sums_;
};

/// Copies what is known of a run's edges but for `margin` at its ends: along an outline, so the run
/// may pass its first edge, as it may have then.
void copy_turns(const StayedRun& run, std::int32_t margin, std::int32_t count,
                const std::uint8_t* then, std::uint8_t* now) {
  std::int32_t i = margin;
  while (i < run.count - margin) {
    const std::int32_t to = (run.first + i) % count;
    const std::int32_t from = (run.old_first + i) % run.old_outline_count;
    const std::int32_t length =
        std::min({run.count - margin - i, count - to, run.old_outline_count - from});
    std::copy_n(then + from, length, now + to);
    i += length;
  }
}

}  // namespace

OutlineTurns find_turns(const Outlines& outlines, const TurnRule& rule) {
  const std::vector<std::uint8_t> sides = sides_of_edges(outlines);
  OutlineTurns turns;
  for (std::size_t i = 0; i < outlines.list.size(); ++i)
    find_turns(outlines, sides, static_cast<std::int32_t>(i), {}, rule, turns);
  return turns;
}

void find_turns(const Outlines& outlines, const std::vector<std::uint8_t>& sides,
                std::int32_t place, std::span<const StayedRun> stayed, const TurnRule& rule,
                OutlineTurns& turns) {
  const Outline& outline = outlines.list[at(place)];
  turns.turning.resize(outlines.place.size(), 0);
  turns.before.resize(outlines.place.size(), 0);
  turns.whole.resize(outlines.list.size(), 0);
  std::uint8_t* turning = turns.turning.data() + outline.first;
  TurnFinder finder(outline, sides.data() + outline.first, rule, turning);

  // Of edges that are known, those that stay so; they do not overlap.
  const std::int32_t margin = reach_of_turns(rule);
  std::vector<std::pair<std::int32_t, std::int32_t>> known;
  for (const StayedRun& run : stayed) {
    if (run.old_outline_first < 0 || run.count <= 2 * margin ||
        std::min(outline.count, run.old_outline_count) < 4 * margin)
      continue;
    copy_turns(run, margin, outline.count, turns.turning.data() + run.old_outline_first, turning);
    const std::int32_t begin = (run.first + margin) % outline.count;
    const std::int32_t end = begin + run.count - 2 * margin;
    known.emplace_back(begin, std::min(end, outline.count));
    if (end > outline.count) known.emplace_back(0, end - outline.count);
  }
  std::sort(known.begin(), known.end());
  std::int32_t begin = 0;
  for (const auto& [first, last] : known) {
    if (begin < first) finder.mark(begin, first);
    begin = last;
  }
  if (begin < outline.count) finder.mark(begin, outline.count);

  std::int32_t count = 0;
  for (std::int32_t i = 0; i < outline.count; ++i) {
    turns.before[at(outline.first + i)] = count;
    count += turning[i];
  }
  turns.whole[at(place)] = count;
}

std::int32_t reach_of_turns(const TurnRule& rule) {
  const TurnWindow window = window_of(half_of(rule, 0.5));
  const std::int64_t reach = window.half + window.reach + 2;
  return static_cast<std::int32_t>(std::min<std::int64_t>(reach, INT32_MAX / 4));
}

}  // namespace stope::topology
