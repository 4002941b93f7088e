// Problem: pair true points with found ones near them, each used once, as many as possible; a
// greedy choice can block a better one.
// Idea: augmenting paths (Kuhn 1955; Hopcroft and Karp 1973 without its phases, which small
// neighbourhoods do not need), nearest candidates first. Cost: O(points x candidates) in the usual
// case that few points share candidates.
#include "plugins/metric/node_matching.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "plugins/metric/box_tree.hpp"

namespace stope::metric {
namespace {

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

class Matching {
 public:
  Matching(std::vector<std::vector<std::uint32_t>> candidates, std::size_t found_count)
      : candidates_(std::move(candidates)),
        partner_of_found_(found_count, kNone),
        partner_of_truth_(candidates_.size(), kNone),
        seen_(found_count, kNone) {
    for (std::uint32_t t = 0; t < candidates_.size(); ++t) augment(t);
  }
  std::uint32_t partner(std::uint32_t truth) const { return partner_of_truth_[truth]; }

 private:
  // Depth first without recursion: a path may be as long as there are points.
  void augment(std::uint32_t root) {
    std::vector<std::pair<std::uint32_t, std::size_t>> path{{root, 0}};  // point, next candidate
    while (!path.empty()) {
      auto& [truth, next] = path.back();
      if (next == candidates_[truth].size()) {
        path.pop_back();
        continue;
      }
      const std::uint32_t found = candidates_[truth][next++];
      if (seen_[found] == root) continue;
      seen_[found] = root;
      const std::uint32_t holder = partner_of_found_[found];
      if (holder != kNone) {
        path.emplace_back(holder, 0);
        continue;
      }
      for (const auto& [on_path, taken] : path) {
        const std::uint32_t candidate = candidates_[on_path][taken - 1];
        partner_of_truth_[on_path] = candidate;
        partner_of_found_[candidate] = on_path;
      }
      return;
    }
  }

  std::vector<std::vector<std::uint32_t>> candidates_;
  std::vector<std::uint32_t> partner_of_found_, partner_of_truth_;
  std::vector<std::uint32_t> seen_;  // the root that last came by
};

}  // namespace

std::vector<MatchedPair> match_points(const std::vector<Vector2>& truth,
                                      const std::vector<Vector2>& found, double within) {
  std::vector<Box> boxes;
  boxes.reserve(found.size());
  for (const Vector2& point : found) boxes.push_back(box_of(point, point));
  const BoxTree tree(std::move(boxes));
  std::vector<std::vector<std::uint32_t>> candidates(truth.size());
  for (std::size_t t = 0; t < truth.size(); ++t) {
    std::vector<std::pair<double, std::uint32_t>> near;
    tree.visit_touching(box_of(truth[t], truth[t]).widened(within), [&](std::uint32_t f) {
      const double distance = (found[f] - truth[t]).norm();
      if (distance <= within) near.emplace_back(distance, f);
    });
    std::sort(near.begin(), near.end());
    for (const auto& [distance, f] : near) candidates[t].push_back(f);
  }
  const Matching matching(std::move(candidates), found.size());
  std::vector<MatchedPair> pairs;
  for (std::uint32_t t = 0; t < truth.size(); ++t) {
    const std::uint32_t f = matching.partner(t);
    if (f != kNone) pairs.push_back({t, f, (found[f] - truth[t]).norm()});
  }
  return pairs;
}

}  // namespace stope::metric
