// Problem: which way does a shortcut a-b stand for, if only the needed shortcuts were kept?
// Idea: of all nodes below that a way as cheap leads over, let z be the most important. Then both
// a-z and z-b were kept: had a node y above z made a-z needless, the way a-y-z-b would be as cheap;
// if y lies below a and b, it would have been taken instead of z, and if not, a-b itself would be
// needless. So for each a its lower neighbours z are gone through from the most important one down,
// until all of a's shortcuts are explained. Cost: the triangles among kept arcs at worst, a small
// part of those among all.
#include "plugins/planner/shortcut_parts.hpp"

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <stdexcept>

namespace stope::planner {
namespace {

using Parts = ContractionHierarchy::Parts;

/// Arcs by the place of their higher end, then of their lower one.
struct ByHigher {
  struct Lower {
    std::uint32_t place = 0, arc = 0;
  };
  std::vector<std::uint32_t> first;
  std::vector<Lower> arcs;
  explicit ByHigher(const KeptArcs& half) : first(half.first.size(), 0), arcs(half.arcs.size()) {
    for (const SearchArc& arc : half.arcs) ++first[arc.to + 1];
    for (std::size_t i = 1; i < first.size(); ++i) first[i] += first[i - 1];
    std::vector<std::uint32_t> next(first.begin(), first.end() - 1);
    for (std::uint32_t place = 0; place + 1 < half.first.size(); ++place)
      for (std::uint32_t arc = half.first[place]; arc < half.first[place + 1]; ++arc)
        arcs[next[half.arcs[arc].to]++] = {place, arc};
  }
};

class Explanation {
 public:
  Explanation(const KeptHalves& kept, std::span<const CellLink> links)
      : kept_(kept), links_(links), up_(kept.up), down_(kept.down) {
    parts_.up.resize(kept.up.arcs.size());
    parts_.down.resize(kept.down.arcs.size());
    for (std::uint32_t i = 0; i < links.size(); ++i) into_.push_back(i);
    std::sort(into_.begin(), into_.end(), [&](std::uint32_t a, std::uint32_t b) {
      return std::pair(links[a].to, links[a].from) < std::pair(links[b].to, links[b].from);
    });
  }

  ShortcutParts parts(std::uint32_t first_up, std::uint32_t first_down) {
    const auto count = static_cast<std::uint32_t>(kept_.up.first.size() - 1);
    tbb::enumerable_thread_specific<std::vector<std::uint32_t>> slots(
        [count] { return std::vector<std::uint32_t>(count, kNoArc); });
    tbb::this_task_arena::isolate([&] {
      tbb::parallel_for(tbb::blocked_range<std::uint32_t>(0, count, 256),
                        [&](const tbb::blocked_range<std::uint32_t>& range) {
                          auto& slot = slots.local();
                          for (std::uint32_t a = range.begin(); a < range.end(); ++a) {
                            explain(a, true, slot);
                            explain(a, false, slot);
                          }
                        });
    });
    for (auto* half : {&parts_.up, &parts_.down}) {
      for (Parts& parts : *half) {
        if (parts.down == kNoArc) continue;
        parts.down += first_down;
        parts.up += first_up;
      }
    }
    return std::move(parts_);
  }

 private:
  /// The arcs up from a, or those down to it. `slot` gives an arc's number by its other end.
  void explain(std::uint32_t a, bool is_up, std::vector<std::uint32_t>& slot) {
    const KeptArcs& own = is_up ? kept_.up : kept_.down;
    auto& parts = is_up ? parts_.up : parts_.down;
    std::uint32_t open = own.first[a + 1] - own.first[a];
    if (open == 0) return;
    for (std::uint32_t arc = own.first[a]; arc < own.first[a + 1]; ++arc)
      slot[own.arcs[arc].to] = arc;
    const auto settle = [&](std::uint32_t to, std::uint32_t cost, const Parts& found) {
      const std::uint32_t arc = slot[to];
      if (arc == kNoArc || own.arcs[arc].cost != cost) return;
      parts[arc] = found;
      slot[to] = kNoArc;
      --open;
    };
    for_links(a, is_up, [&](const CellLink& link) {
      settle(is_up ? link.to : link.from, link.cost, link.parts);
    });
    // Up: a-z is an arc down, z-b one up. Down: b-z is an arc down, z-a one up.
    const ByHigher& lower = is_up ? down_ : up_;
    const KeptArcs& first_half = is_up ? kept_.down : kept_.up;
    const KeptArcs& second_half = is_up ? kept_.up : kept_.down;
    for (std::uint32_t i = lower.first[a + 1]; open > 0 && i-- > lower.first[a];) {
      const auto [z, near] = lower.arcs[i];
      const std::uint32_t cost = first_half.arcs[near].cost;
      for (std::uint32_t far = second_half.first[z + 1]; far-- > second_half.first[z];) {
        const SearchArc& arc = second_half.arcs[far];
        if (arc.to <= a) break;
        settle(arc.to, cost + arc.cost, is_up ? Parts{near, far} : Parts{far, near});
      }
    }
    for (std::uint32_t arc = own.first[a]; arc < own.first[a + 1]; ++arc)
      slot[own.arcs[arc].to] = kNoArc;
    if (open > 0) throw std::logic_error("a shortcut stands for no way");
  }

  template <class Use>
  void for_links(std::uint32_t a, bool is_up, const Use& use) const {
    if (is_up) {
      auto at = std::partition_point(links_.begin(), links_.end(),
                                     [a](const CellLink& link) { return link.from < a; });
      for (; at != links_.end() && at->from == a; ++at) use(*at);
    } else {
      auto at = std::partition_point(into_.begin(), into_.end(),
                                     [&](std::uint32_t i) { return links_[i].to < a; });
      for (; at != into_.end() && links_[*at].to == a; ++at) use(links_[*at]);
    }
  }

  const KeptHalves& kept_;
  std::span<const CellLink> links_;  // by from, then to
  std::vector<std::uint32_t> into_;  // the same by to, then from
  ByHigher up_, down_;
  ShortcutParts parts_;
};

}  // namespace

ShortcutParts shortcut_parts(const KeptHalves& kept, std::span<const CellLink> links,
                             std::uint32_t first_up, std::uint32_t first_down) {
  return Explanation(kept, links).parts(first_up, first_down);
}

}  // namespace stope::planner
