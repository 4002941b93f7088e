// Problem: which is the smallest set of nodes that touches all links between two sides?
// Idea: a greatest matching, grown by paths that alternate (Kuhn 1955), has as many links as the
// set has nodes (König 1931): of each matched pair it takes the right node where a path from an
// unmatched left one leads to it, else the left one.
#include "plugins/planner/least_cover.hpp"

#include <limits>

namespace stope::planner {
namespace {

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

class Matching {
 public:
  explicit Matching(const TwoSides& links)
      : links_(links),
        mate_of_left_(links.first.size() - 1, kNone),
        mate_of_right_(links.right_count, kNone),
        seen_by_(links.right_count, kNone) {
    for (std::uint32_t left = 0; left < mate_of_left_.size(); ++left) augment(left);
  }

  Cover cover() const {
    std::vector<bool> reached(links_.right_count, false);
    std::vector<std::uint32_t> waiting;
    for (std::uint32_t left = 0; left < mate_of_left_.size(); ++left)
      if (mate_of_left_[left] == kNone) waiting.push_back(left);
    while (!waiting.empty()) {
      const std::uint32_t left = waiting.back();
      waiting.pop_back();
      for (std::uint32_t i = links_.first[left]; i < links_.first[left + 1]; ++i) {
        const std::uint32_t right = links_.right[i];
        if (reached[right]) continue;
        reached[right] = true;
        if (mate_of_right_[right] != kNone) waiting.push_back(mate_of_right_[right]);
      }
    }
    Cover cover{std::vector<bool>(mate_of_left_.size(), false),
                std::vector<bool>(links_.right_count, false)};
    for (std::uint32_t left = 0; left < mate_of_left_.size(); ++left) {
      const std::uint32_t right = mate_of_left_[left];
      if (right == kNone) continue;
      if (reached[right])
        cover.right[right] = true;
      else
        cover.left[left] = true;
    }
    return cover;
  }

 private:
  struct Step {
    std::uint32_t left, next;  // the next of left's links to look at
  };

  /// By hand, as paths may be thousands of nodes long.
  void augment(std::uint32_t from) {
    steps_.assign(1, {from, links_.first[from]});
    taken_.clear();
    while (!steps_.empty()) {
      auto& [left, next] = steps_.back();
      while (next < links_.first[left + 1] && seen_by_[links_.right[next]] == from) ++next;
      if (next == links_.first[left + 1]) {
        steps_.pop_back();
        if (!taken_.empty()) taken_.pop_back();
        continue;
      }
      const std::uint32_t right = links_.right[next];
      seen_by_[right] = from;
      taken_.push_back(right);
      if (mate_of_right_[right] == kNone) {
        for (std::size_t i = steps_.size(); i-- > 0;) {
          mate_of_right_[taken_[i]] = steps_[i].left;
          mate_of_left_[steps_[i].left] = taken_[i];
        }
        return;
      }
      steps_.push_back({mate_of_right_[right], links_.first[mate_of_right_[right]]});
    }
  }

  const TwoSides& links_;
  std::vector<std::uint32_t> mate_of_left_, mate_of_right_;
  std::vector<std::uint32_t> seen_by_;  // of each right node: the last that looked for a mate
  std::vector<Step> steps_;
  std::vector<std::uint32_t> taken_;  // right nodes the steps lead over
};

}  // namespace

Cover least_cover(const TwoSides& links) { return Matching(links).cover(); }

}  // namespace stope::planner
