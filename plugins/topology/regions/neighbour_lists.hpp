#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

namespace stope::topology {

/// What each region has in common with each of its neighbours, which are few: short lists.
template <class Common>
class NeighbourLists {
 public:
  struct Neighbour {
    std::int32_t region = 0;
    Common common{};
  };

  explicit NeighbourLists(std::size_t regions) : lists_(regions) {}

  const std::vector<Neighbour>& of(std::int32_t region) const { return list(region); }
  /// A neighbour that the first has not yet.
  void add(std::int32_t region, std::int32_t neighbour, const Common& common) {
    constexpr std::size_t kMost = 6;  // of most regions
    auto& own = list(region);
    if (own.empty()) own.reserve(kMost);
    own.push_back({neighbour, common});
  }
  /// What the first has in common with the second, nothing yet if they were none.
  Common& at(std::int32_t region, std::int32_t neighbour) {
    auto& own = list(region);
    const auto found = std::find_if(
        own.begin(), own.end(), [&](const Neighbour& other) { return other.region == neighbour; });
    if (found != own.end()) return found->common;
    return own.emplace_back(Neighbour{neighbour, {}}).common;
  }
  /// The neighbours of `gone` become those of `kept`, with `add(common, more)` what they have in
  /// common with both.
  template <class Add>
  void join(std::int32_t gone, std::int32_t kept, Add add) {
    const std::vector<Neighbour> those = std::move(list(gone));
    list(gone).clear();
    for (const auto& [other, common] : those) {
      std::erase_if(list(other), [&](const Neighbour& back) { return back.region == gone; });
      if (other == kept) continue;
      add(at(kept, other), common);
      add(at(other, kept), common);
    }
  }

 private:
  std::vector<Neighbour>& list(std::int32_t region) {
    return lists_[static_cast<std::size_t>(region)];
  }
  const std::vector<Neighbour>& list(std::int32_t region) const {
    return lists_[static_cast<std::size_t>(region)];
  }
  std::vector<std::vector<Neighbour>> lists_;
};

}  // namespace stope::topology
