// Problem: what is left of a dense, grid-like network after its easy nodes are gone has so many
// ways that searches for witnesses never end. Idea: customizable contraction hierarchies (Dibbelt,
// Strasser and Wagner 2014). Which nodes get joined follows from the order alone, whatever the
// costs: a node's later neighbours are joined to each other. Then the costs: each link takes the
// least over the triangles below it; after that, from the last node to the first, a link goes that
// a triangle above it or astride makes needless (as dear is needless too, since costs are positive:
// see the proof at `keep`). What is left is a small hierarchy without a single search. Cost: with
// an order by nested dissection O(n log n) links and O(n^1.5) triangles, a nanosecond or two each;
// 44 bytes a link while it runs.
#include "plugins/planner/core_contraction.hpp"

#include <algorithm>
#include <limits>

#include "stope/error.hpp"

namespace stope::planner {
namespace {

// Two of kNever can be added without overflow, and two costs below kMost stay below kNever.
constexpr std::uint32_t kNever = 0x7FFFFFFF, kMost = 0x3FFFFFFF;

/// Of a link between two nodes, lower and higher in the order: one number a direction.
struct Both {
  std::uint32_t up = kNever, down = kNever;
};

class Core {
 public:
  Core(std::span<const std::uint32_t> order, std::span<const CoreLink> links,
       ContractionHierarchy::Half& up, ContractionHierarchy::Half& down,
       const std::function<void()>& pause)
      : order_(order), links_(links), up_(up), down_(down), pause_(pause) {}

  void contract() {
    join_neighbours();
    take_costs();
    list_lower();
    take_triangles_below();
    keep_needed();
    emit();
  }

 private:
  std::uint32_t count() const { return static_cast<std::uint32_t>(order_.size()); }

  /// Which nodes are joined: a node passes its later neighbours on to the first of them.
  void join_neighbours() {
    std::vector<std::vector<std::uint32_t>> later(count());
    for (const CoreLink& link : links_)
      later[std::min(link.from, link.to)].push_back(std::max(link.from, link.to));
    first_.assign(1, 0);
    for (std::uint32_t node = 0; node < count(); ++node) {
      if (node % 4096 == 0) pause_();
      auto& list = later[node];
      std::sort(list.begin(), list.end());
      list.erase(std::unique(list.begin(), list.end()), list.end());
      head_.insert(head_.end(), list.begin(), list.end());
      tail_.resize(head_.size(), node);
      if (head_.size() >= kNever)
        throw Error("the road graph is too dense to prepare for fast search");
      first_.push_back(static_cast<std::uint32_t>(head_.size()));
      if (list.size() > 1) {
        auto& heir = later[list.front()];
        heir.insert(heir.end(), list.begin() + 1, list.end());
        // Else the lists of important nodes hold the same neighbours a hundred times over.
        if (heir.size() > 64 && heir.size() > 2 * list.size()) {
          std::sort(heir.begin(), heir.end());
          heir.erase(std::unique(heir.begin(), heir.end()), heir.end());
        }
      }
      std::vector<std::uint32_t>().swap(list);
    }
  }

  std::uint32_t link_between(std::uint32_t low, std::uint32_t high) const {
    const auto begin = head_.begin() + first_[low], end = head_.begin() + first_[low + 1];
    return static_cast<std::uint32_t>(std::lower_bound(begin, end, high) - head_.begin());
  }

  void take_costs() {
    cost_.resize(head_.size());
    middle_.assign(head_.size(), {kNoArc, kNoArc});
    for (const CoreLink& link : links_) {
      if (link.cost > kMost) refuse();
      Both& cost = cost_[link_between(std::min(link.from, link.to), std::max(link.from, link.to))];
      (link.from < link.to ? cost.up : cost.down) = link.cost;
    }
  }

  /// For each node the links that lead up to it, lowest first.
  void list_lower() {
    first_lower_.assign(count() + 1, 0);
    for (const std::uint32_t node : head_) ++first_lower_[node + 1];
    for (std::uint32_t node = 0; node < count(); ++node)
      first_lower_[node + 1] += first_lower_[node];
    lower_.resize(head_.size());
    std::vector<std::uint32_t> next(first_lower_.begin(), first_lower_.end() - 1);
    for (std::uint32_t link = 0; link < head_.size(); ++link) lower_[next[head_[link]]++] = link;
  }

  void take_triangles_below() {
    std::vector<Both> best(count()), by(count());
    for (std::uint32_t node = 0; node < count(); ++node) {
      if (node % 256 == 0) pause_();
      for (std::uint32_t link = first_[node]; link < first_[node + 1]; ++link) {
        best[head_[link]] = cost_[link];
        by[head_[link]] = {kNoArc, kNoArc};
      }
      for (std::uint32_t i = first_lower_[node]; i < first_lower_[node + 1]; ++i) {
        const std::uint32_t link = lower_[i], below = tail_[link];
        const Both here = cost_[link];
        for (std::uint32_t on = link + 1; on < first_[below + 1]; ++on) {
          Both& known = best[head_[on]];
          if (here.down + cost_[on].up < known.up) {
            known.up = here.down + cost_[on].up;
            by[head_[on]].up = below;
          }
          if (here.up + cost_[on].down < known.down) {
            known.down = here.up + cost_[on].down;
            by[head_[on]].down = below;
          }
        }
      }
      for (std::uint32_t link = first_[node]; link < first_[node + 1]; ++link) {
        cost_[link] = best[head_[link]];
        middle_[link] = by[head_[link]];
        for (const std::uint32_t cost : {cost_[link].up, cost_[link].down})
          if (cost > kMost && cost < kNever) refuse();
      }
    }
  }

  /// From the last node to the first: the true cost between each two joined nodes, and which links
  /// to keep. A link v-b goes if some third node a above v has cost(v, a) + cost(a, b) <= cost(v,
  /// b). The ways left suffice: let x be the most important node on any cheapest way from s to t.
  /// If the first link s-y of a climb to x is gone, some a made it needless; a lies on a cheapest
  /// way to x, is above s, and nearer to it than y; so among such a the nearest has its link kept,
  /// and the climb goes on from there to x, which is nearer now.
  void keep_needed() {
    std::vector<Both> truth = cost_;
    keep_.assign(head_.size(), 0);
    std::vector<std::uint32_t> slot(count());
    std::vector<Both> own, round;
    for (std::uint32_t node = count(); node-- > 0;) {
      if (node % 256 == 0) pause_();
      const std::uint32_t begin = first_[node], size = first_[node + 1] - begin;
      // The last place takes what belongs to nodes that are not joined to this one.
      own.assign(size + 1, {});
      round.assign(size + 1, {});
      for (std::uint32_t i = 0; i < size; ++i) {
        own[i] = cost_[begin + i];
        slot[head_[begin + i]] = i;
      }
      for (std::uint32_t i = 0; i < size; ++i) {
        const std::uint32_t over = head_[begin + i];
        const Both here = own[i];
        Both best = round[i];
        for (std::uint32_t link = first_[over]; link < first_[over + 1]; ++link) {
          std::uint32_t k = slot[head_[link]];
          k = k < size && head_[begin + k] == head_[link] ? k : size;
          const Both across = truth[link];
          round[k].up = std::min(round[k].up, here.up + across.up);
          round[k].down = std::min(round[k].down, here.down + across.down);
          best.up = std::min(best.up, own[k].up + across.down);
          best.down = std::min(best.down, own[k].down + across.up);
        }
        round[i] = best;
      }
      for (std::uint32_t i = 0; i < size; ++i) {
        keep_[begin + i] = static_cast<std::uint8_t>((own[i].up < round[i].up ? 1 : 0) +
                                                     (own[i].down < round[i].down ? 2 : 0));
        truth[begin + i] = {std::min(own[i].up, round[i].up), std::min(own[i].down, round[i].down)};
      }
    }
  }

  /// Writes the links that are kept, and past the ends of all nodes' those that only they stand
  /// for.
  void emit() {
    place_.assign(head_.size(), {kNoArc, kNoArc});
    for (std::uint32_t node = 0; node < count(); ++node) {
      up_.first.push_back(static_cast<std::uint32_t>(up_.arcs.size()));
      down_.first.push_back(static_cast<std::uint32_t>(down_.arcs.size()));
      for (std::uint32_t link = first_[node]; link < first_[node + 1]; ++link) {
        if ((keep_[link] & 1) != 0) place_up(link);
        if ((keep_[link] & 2) != 0) place_down(link);
      }
    }
    up_.first.push_back(static_cast<std::uint32_t>(up_.arcs.size()));
    down_.first.push_back(static_cast<std::uint32_t>(down_.arcs.size()));
    while (!waiting_.empty()) {
      const auto [link, is_up] = waiting_.back();
      waiting_.pop_back();
      const ContractionHierarchy::Parts parts = parts_of(link, is_up);
      (is_up ? up_.parts[place_[link].up] : down_.parts[place_[link].down]) = parts;
    }
  }

  std::uint32_t place_up(std::uint32_t link) {
    return put(up_, place_[link].up, {order_[head_[link]], cost_[link].up}, {link, true});
  }
  std::uint32_t place_down(std::uint32_t link) {
    return put(down_, place_[link].down, {order_[head_[link]], cost_[link].down}, {link, false});
  }
  struct Waiting {
    std::uint32_t link;
    bool is_up;
  };
  std::uint32_t put(ContractionHierarchy::Half& half, std::uint32_t& place, SearchArc arc,
                    Waiting waiting) {
    if (place == kNoArc) {
      place = static_cast<std::uint32_t>(half.arcs.size());
      half.arcs.push_back(arc);
      half.parts.push_back({});
      waiting_.push_back(waiting);
    }
    return place;
  }

  ContractionHierarchy::Parts parts_of(std::uint32_t link, bool is_up) {
    const std::uint32_t from = is_up ? tail_[link] : head_[link];
    const std::uint32_t to = is_up ? head_[link] : tail_[link];
    const std::uint32_t middle = is_up ? middle_[link].up : middle_[link].down;
    if (middle == kNoArc) {
      const auto found = std::lower_bound(
          links_.begin(), links_.end(), std::pair(from, to),
          [](const CoreLink& a, const auto& b) { return std::pair(a.from, a.to) < b; });
      return found->parts;
    }
    return {place_down(link_between(middle, from)), place_up(link_between(middle, to))};
  }

  [[noreturn]] static void refuse() {
    throw Error("the road graph has ways too long to prepare for fast search");
  }

  std::span<const std::uint32_t> order_;
  std::span<const CoreLink> links_;
  ContractionHierarchy::Half &up_, &down_;
  const std::function<void()>& pause_;
  // Links by lower end, then higher: ends, costs over what lies below, and the node they lead over.
  std::vector<std::uint32_t> first_, head_, tail_;
  std::vector<Both> cost_, middle_, place_;
  std::vector<std::uint8_t> keep_;
  std::vector<std::uint32_t> first_lower_, lower_;
  std::vector<Waiting> waiting_;
};

}  // namespace

void contract_core(std::span<const std::uint32_t> order, std::span<const CoreLink> links,
                   ContractionHierarchy::Half& up, ContractionHierarchy::Half& down,
                   const std::function<void()>& pause) {
  Core(order, links, up, down, pause).contract();
}

}  // namespace stope::planner
