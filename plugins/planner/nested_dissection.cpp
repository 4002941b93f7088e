// Problem: in which order should the nodes of a dense, flat network be taken out, so that few
// shortcuts appear?
// Idea: nested dissection (George 1973). The nodes are swept in four directions; of all straight
// cuts that leave at least a third on either side the one that the fewest links cross is taken, and
// the smallest set of nodes that touches all of these links (a least vertex cover, by König's
// theorem from a greatest matching) parts the rest into two, which are treated alike. Within such a
// set the middle one comes last, so that climbing along it takes few steps.
// Cost: O(n log n) a level, some twenty levels.
#include "plugins/planner/nested_dissection.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <limits>

namespace stope::planner {
namespace {

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
constexpr std::array<std::array<float, 2>, 4> kSweeps{{{1, 0}, {0, 1}, {1, 1}, {1, -1}}};

/// A greatest matching of two sides' nodes, along links between them (Kuhn), and from it the
/// smallest set of nodes that touches all links.
class LeastCover {
 public:
  explicit LeastCover(std::uint32_t nodes) : mate_(nodes, kNone), seen_(nodes, 0) {}

  /// `across(node)` lists the other side's neighbours of one of `left`.
  template <class Across>
  std::vector<std::uint32_t> of(const std::vector<std::uint32_t>& left, const Across& across) {
    for (const std::uint32_t node : left) {
      ++round_;
      augment(node, across);
    }
    // Nodes that alternating paths from unmatched left ones lead to.
    ++round_;
    for (const std::uint32_t node : left)
      if (mate_[node] == kNone) reach(node, across);
    std::vector<std::uint32_t> cover;
    for (const std::uint32_t node : left) {
      if (mate_[node] == kNone) continue;
      cover.push_back(seen_[mate_[node]] == round_ ? mate_[node] : node);
    }
    for (const std::uint32_t node : left) {
      if (mate_[node] != kNone) mate_[mate_[node]] = kNone;
      mate_[node] = kNone;
    }
    return cover;
  }

 private:
  struct Step {
    std::uint32_t left, next;  // next of left's neighbours to look at
  };

  template <class Across>
  void augment(std::uint32_t from, const Across& across) {
    // By hand, as paths may be thousands of nodes long.
    steps_.assign(1, {from, 0});
    taken_.clear();
    while (!steps_.empty()) {
      auto& [left, next] = steps_.back();
      const auto& others = across(left);
      while (next < others.size() && seen_[others[next]] == round_) ++next;
      if (next == others.size()) {
        steps_.pop_back();
        if (!taken_.empty()) taken_.pop_back();
        continue;
      }
      const std::uint32_t right = others[next];
      seen_[right] = round_;
      taken_.push_back(right);
      if (mate_[right] == kNone) {
        for (std::size_t i = steps_.size(); i-- > 0;) {
          mate_[taken_[i]] = steps_[i].left;
          mate_[steps_[i].left] = taken_[i];
        }
        return;
      }
      steps_.push_back({mate_[right], 0});
    }
  }

  template <class Across>
  void reach(std::uint32_t from, const Across& across) {
    std::vector<std::uint32_t> waiting{from};
    while (!waiting.empty()) {
      const std::uint32_t node = waiting.back();
      waiting.pop_back();
      for (const std::uint32_t right : across(node)) {
        if (seen_[right] == round_) continue;
        seen_[right] = round_;
        if (mate_[right] != kNone) waiting.push_back(mate_[right]);
      }
    }
  }

  std::vector<std::uint32_t> mate_, seen_;
  std::vector<Step> steps_;
  std::vector<std::uint32_t> taken_;  // right nodes the steps lead over
  std::uint32_t round_ = 0;
};

class Dissection {
 public:
  Dissection(const NeighbourLists& neighbours, std::span<const NodePlace> places)
      : neighbours_(neighbours),
        places_(places),
        position_(places.size(), kNone),
        across_(places.size()),
        cover_(static_cast<std::uint32_t>(places.size())) {}

  std::vector<std::uint32_t> order() {
    std::vector<std::uint32_t> nodes(places_.size());
    for (std::uint32_t i = 0; i < nodes.size(); ++i) nodes[i] = i;
    part(std::move(nodes));
    return std::move(order_);
  }

 private:
  void sort(std::vector<std::uint32_t>& nodes, const std::array<float, 2>& along) const {
    std::vector<std::pair<float, std::uint32_t>> keys;
    keys.reserve(nodes.size());
    for (const std::uint32_t node : nodes)
      keys.emplace_back(along[0] * places_[node].x + along[1] * places_[node].y, node);
    std::sort(keys.begin(), keys.end());
    for (std::size_t i = 0; i < keys.size(); ++i) nodes[i] = keys[i].second;
  }

  /// Writes where in `nodes` each stands, or that it stands nowhere.
  void place(const std::vector<std::uint32_t>& nodes, bool known) {
    for (std::uint32_t i = 0; i < nodes.size(); ++i) position_[nodes[i]] = known ? i : kNone;
  }

  /// The cut that the fewest links cross: how many nodes lie before it, and how many links.
  std::pair<std::size_t, std::int64_t> best_cut(const std::vector<std::uint32_t>& nodes) const {
    std::vector<std::int64_t> change(nodes.size() + 1, 0);
    for (std::uint32_t i = 0; i < nodes.size(); ++i) {
      for (const std::uint32_t other : neighbours_.of(nodes[i])) {
        if (position_[other] == kNone || position_[other] <= i) continue;
        ++change[i + 1];
        --change[position_[other] + 1];
      }
    }
    const std::size_t count = nodes.size(), middle = count / 2;
    std::pair<std::size_t, std::int64_t> best{middle, std::numeric_limits<std::int64_t>::max()};
    const auto from_middle = [&](std::size_t k) { return k > middle ? k - middle : middle - k; };
    std::int64_t crossing = 0;
    for (std::size_t k = 0; k <= count; ++k) {
      crossing += change[k];
      if (3 * k < count || 3 * (count - k) < count) continue;
      if (crossing < best.second ||
          (crossing == best.second && from_middle(k) < from_middle(best.first)))
        best = {k, crossing};
    }
    return best;
  }

  void part(std::vector<std::uint32_t> nodes) {
    if (nodes.size() <= 3) {
      order_.insert(order_.end(), nodes.begin(), nodes.end());
      return;
    }
    std::size_t sweep = 0;
    std::pair<std::size_t, std::int64_t> best{0, std::numeric_limits<std::int64_t>::max()};
    for (std::size_t i = 0; i < kSweeps.size(); ++i) {
      sort(nodes, kSweeps[i]);
      place(nodes, true);
      const auto cut = best_cut(nodes);
      if (cut.second < best.second) best = cut, sweep = i;
    }
    sort(nodes, kSweeps[sweep]);
    place(nodes, true);
    std::vector<std::uint32_t> left;
    for (std::uint32_t i = 0; i < best.first; ++i) {
      auto& across = across_[nodes[i]];
      across.clear();
      for (const std::uint32_t other : neighbours_.of(nodes[i]))
        if (position_[other] != kNone && position_[other] >= best.first) across.push_back(other);
      if (!across.empty()) left.push_back(nodes[i]);
    }
    std::vector<std::uint32_t> between = cover_.of(
        left,
        [this](std::uint32_t node) -> const std::vector<std::uint32_t>& { return across_[node]; });
    for (const std::uint32_t node : between) position_[node] = kNone;
    std::vector<std::uint32_t> before, after;
    for (std::uint32_t i = 0; i < nodes.size(); ++i)
      if (position_[nodes[i]] != kNone) (i < best.first ? before : after).push_back(nodes[i]);
    place(nodes, false);
    std::vector<std::uint32_t>().swap(nodes);
    part(std::move(before));
    part(std::move(after));
    sort(between, {-kSweeps[sweep][1], kSweeps[sweep][0]});
    middle_last(between, 0, between.size());
  }

  void middle_last(const std::vector<std::uint32_t>& nodes, std::size_t begin, std::size_t end) {
    if (begin == end) return;
    const std::size_t middle = begin + (end - begin) / 2;
    middle_last(nodes, begin, middle);
    middle_last(nodes, middle + 1, end);
    order_.push_back(nodes[middle]);
  }

  const NeighbourLists& neighbours_;
  std::span<const NodePlace> places_;
  std::vector<std::uint32_t> position_;             // in the part at hand
  std::vector<std::vector<std::uint32_t>> across_;  // scratch
  LeastCover cover_;
  std::vector<std::uint32_t> order_;
};

}  // namespace

std::vector<std::uint32_t> dissection_order(const NeighbourLists& neighbours,
                                            std::span<const NodePlace> places) {
  return Dissection(neighbours, places).order();
}

}  // namespace stope::planner
