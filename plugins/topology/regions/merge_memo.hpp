#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <unordered_map>
#include <vector>

#include "plugins/topology/regions/region_shape.hpp"

namespace stope::topology {

/// Which shapes were tried to be merged and whether that was allowed, for the next map, in which
/// most are the same. A shape is known by a number; what two of them became has one too. Looked
/// up, never gone through.
class MergeMemo {
 public:
  using Shape = std::uint32_t;

  /// The names' shapes are others now.
  void renew(const std::vector<std::int32_t>& names, std::size_t all_names) {
    of_name_.resize(all_names, 0);
    for (const std::int32_t name : names) of_name_[static_cast<std::size_t>(name)] = ++last_;
  }
  Shape shape_of(std::size_t name) const { return of_name_[name]; }

  std::optional<bool> allowed(Shape a, Shape b) {
    const auto found = pairs_.find(key(a, b));
    if (found == pairs_.end()) return std::nullopt;
    found->second.turn = turn_;
    return found->second.allowed;
  }
  void note(Shape a, Shape b, bool allowed) { pairs_[key(a, b)] = {turn_, allowed, {}}; }
  struct Merged {
    Shape number = 0;
    std::shared_ptr<const RegionShape> shape;
  };
  /// What the first becomes with the second, which has been allowed: as made by make().
  template <class Make>
  const Merged& merged(Shape a, Shape b, Make make) {
    Merged& merged = pairs_[key(a, b)].merged;
    if (!merged.shape) merged = {++last_, std::make_shared<const RegionShape>(make())};
    return merged;
  }
  /// Forgets what was not asked for since the last call.
  void forget_unused() {
    std::erase_if(pairs_, [&](const auto& entry) { return entry.second.turn != turn_; });
    ++turn_;
  }

 private:
  struct Pair {
    std::uint32_t turn = 0;
    bool allowed = false;
    Merged merged;
  };
  static std::uint64_t key(Shape a, Shape b) { return std::uint64_t{a} << 32 | b; }

  std::vector<Shape> of_name_;
  std::unordered_map<std::uint64_t, Pair> pairs_;
  Shape last_ = 0;
  std::uint32_t turn_ = 0;
};

}  // namespace stope::topology
