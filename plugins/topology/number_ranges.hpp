#pragma once

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <map>
#include <set>
#include <utility>

namespace stope::topology {

/// Ranges of numbers that nobody uses. Those side by side are one.
class NumberRanges {
 public:
  void clear() {
    count_at_.clear();
    by_count_.clear();
  }
  void give_back(std::int32_t first, std::int32_t count) {
    auto next = count_at_.lower_bound(first);
    if (next != count_at_.end() && next->first == first + count) {
      count += next->second;
      next = remove(next);
    }
    if (next != count_at_.begin())
      if (const auto before = std::prev(next); before->first + before->second == first) {
        first = before->first;
        count += before->second;
        remove(before);
      }
    add(first, count);
  }
  /// The first of `count` numbers, which are somebody's from now on: of a range that they fill
  /// best, the first one. -1 if there is none.
  std::int32_t take(std::int32_t count) {
    const auto best = by_count_.lower_bound({count, 0});
    if (best == by_count_.end()) return -1;
    const auto [all, first] = *best;
    remove(count_at_.find(first));
    if (all > count) add(first + count, all - count);
    return first;
  }

 private:
  using ByFirst = std::map<std::int32_t, std::int32_t>;
  void add(std::int32_t first, std::int32_t count) {
    count_at_.emplace(first, count);
    by_count_.emplace(count, first);
  }
  ByFirst::iterator remove(ByFirst::iterator range) {
    by_count_.erase({range->second, range->first});
    return count_at_.erase(range);
  }

  ByFirst count_at_;
  std::set<std::pair<std::int32_t, std::int32_t>> by_count_;
};

}  // namespace stope::topology
