#pragma once

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace stope::topology {

/// Sets of the numbers 0 … count - 1 that can be joined; a set is named by its smallest member.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), 0);
  }
  /// How many members there are.
  std::size_t size() const { return parent_.size(); }
  std::int32_t find(std::int32_t member) {
    while (parent(member) != member) {
      parent(member) = parent(parent(member));
      member = parent(member);
    }
    return member;
  }
  /// Whether they were apart.
  bool join(std::int32_t a, std::int32_t b) {
    a = find(a);
    b = find(b);
    if (a == b) return false;
    parent(a < b ? b : a) = a < b ? a : b;
    return true;
  }

 private:
  std::int32_t& parent(std::int32_t member) { return parent_[static_cast<std::size_t>(member)]; }
  std::vector<std::int32_t> parent_;
};

}  // namespace stope::topology
