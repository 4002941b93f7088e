// Problem: find the few neighbouring cells that a rule divides among all that there are.
// Idea: numbers of edges that differ by little are never divided, so look along stretches where
// both neighbours are free, many pairs at a time, and ask the rule only where some differ by
// more.
#include "plugins/topology/find_divides.hpp"

#include <algorithm>
#include <utility>

#include "plugins/topology/for_each_band.hpp"
#include "plugins/topology/free_runs.hpp"

namespace stope::topology {
namespace {

constexpr std::int32_t kBandRows = 64;
constexpr std::int32_t kBlock = 32;

/// Whether numbers differ by more than `gap`. Signed, as vectors compare: the bias takes 0 to the
/// least number.
bool differ(std::int32_t a, std::int32_t b, std::uint32_t gap) {
  constexpr std::uint32_t kBias = 1U << 31;
  const std::uint32_t apart = static_cast<std::uint32_t>(a) - static_cast<std::uint32_t>(b) + gap;
  return static_cast<std::int32_t>(apart ^ kBias) > static_cast<std::int32_t>((2 * gap) ^ kBias);
}

bool any_differ(const std::int32_t* here, const std::int32_t* there, std::uint32_t gap) {
  std::int32_t far = 0;
  for (std::int32_t i = 0; i < kBlock; ++i) far |= differ(here[i], there[i], gap) ? -1 : 0;
  return far != 0;
}

class RowScan {
 public:
  RowScan(const FreeSpace& space, const SideRule& rule, const EdgeGrid& edges, std::int32_t gap)
      : space_(space), rule_(rule), edges_(edges), gap_(static_cast<std::uint32_t>(gap)) {}

  /// Divides of rows from `bottom` to before `top`.
  std::vector<Divide> run(std::int32_t bottom, std::int32_t top) {
    std::vector<Divide> divides;
    list_runs(bottom, runs_);
    for (std::int32_t row = bottom; row < top; ++row) {
      list_runs(row + 1, above_);
      scan(row);
      const auto before = [](const Divide& a, const Divide& b) {
        return std::pair(a.cell, a.north) < std::pair(b.cell, b.north);
      };
      std::merge(east_.begin(), east_.end(), north_.begin(), north_.end(),
                 std::back_inserter(divides), before);
      std::swap(runs_, above_);
    }
    return divides;
  }

 private:
  struct Run {
    std::int32_t begin = 0, end = 0;
  };

  void list_runs(std::int32_t row, std::vector<Run>& runs) const {
    runs.clear();
    for_each_free_run(space_, row, [&](std::int32_t begin, std::int32_t end) {
      runs.push_back({begin, end});
    });
  }

  void scan(std::int32_t row) {
    east_.clear();
    north_.clear();
    auto other = above_.cbegin();
    for (const Run run : runs_) {
      compare(space_.index(run.begin, row), run.end - 1 - run.begin, false, east_);
      while (other != above_.cend() && other->end <= run.begin) ++other;
      for (auto next = other; next != above_.cend() && next->begin < run.end; ++next) {
        const std::int32_t begin = std::max(run.begin, next->begin);
        compare(space_.index(begin, row), std::min(run.end, next->end) - begin, true, north_);
      }
    }
  }

  /// Compares `count` cells with their eastern or northern neighbours, all of them free.
  void compare(CellIndex cell, std::int32_t count, bool north, std::vector<Divide>& divides) const {
    const std::int32_t* here = edges_.data() + cell;
    const std::int32_t* there = here + (north ? edges_.stride() : 1);
    std::int32_t i = 0;
    const auto ask = [&](std::int32_t end) {
      for (; i < end; ++i)
        if (differ(here[i], there[i], gap_) && rule_.divided(here[i], there[i]))
          divides.push_back({cell + i, north});
    };
    while (i + kBlock <= count) {
      if (any_differ(here + i, there + i, gap_)) {
        ask(i + kBlock);
      } else {
        i += kBlock;
      }
    }
    ask(count);
  }

  const FreeSpace& space_;
  const SideRule& rule_;
  const EdgeGrid& edges_;
  std::uint32_t gap_;
  std::vector<Run> runs_, above_;
  std::vector<Divide> east_, north_;
};

}  // namespace

std::vector<Divide> find_divides_between_free_cells(const FreeSpace& space,
                                                    const Outlines& outlines, const SideRule& rule,
                                                    const EdgeGrid& edges,
                                                    const Checkpoint& checkpoint) {
  const std::int32_t bands = (space.height() + kBandRows - 1) / kBandRows;
  std::vector<std::vector<Divide>> of_band(static_cast<std::size_t>(bands));
  for_each_band(bands, checkpoint, [&] {
    return [&](std::int32_t band) {
      const std::int32_t bottom = band * kBandRows;
      of_band[static_cast<std::size_t>(band)] =
          RowScan(space, rule, edges, outlines.gap)
              .run(bottom, std::min(bottom + kBandRows, space.height()));
    };
  });
  std::vector<Divide> divides;
  for (const std::vector<Divide>& some : of_band)
    divides.insert(divides.end(), some.begin(), some.end());
  return divides;
}

}  // namespace stope::topology
