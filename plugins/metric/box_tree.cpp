#include "plugins/metric/box_tree.hpp"

#include <numeric>
#include <utility>

namespace stope::metric {
namespace {
constexpr std::uint32_t kLeaf = 4;
}

BoxTree::BoxTree(std::vector<Box> boxes) : boxes_(std::move(boxes)), order_(boxes_.size()) {
  std::iota(order_.begin(), order_.end(), 0U);
  if (!boxes_.empty()) build(0, static_cast<std::uint32_t>(boxes_.size()));
}

std::uint32_t BoxTree::build(std::uint32_t first, std::uint32_t count) {
  const auto place = static_cast<std::uint32_t>(nodes_.size());
  Node node;
  for (std::uint32_t i = first; i < first + count; ++i) node.box.grow(boxes_[order_[i]]);
  nodes_.push_back(node);
  if (count <= kLeaf) {
    nodes_[place].first = first;
    nodes_[place].count = count;
    return place;
  }
  const Vector2 size = node.box.high - node.box.low;
  const int axis = size.x() >= size.y() ? 0 : 1;
  const std::uint32_t half = count / 2;
  const auto begin = order_.begin() + first;
  std::nth_element(begin, begin + half, begin + count, [&](std::uint32_t a, std::uint32_t b) {
    const double low = boxes_[a].low[axis] + boxes_[a].high[axis];
    const double high = boxes_[b].low[axis] + boxes_[b].high[axis];
    return std::pair(low, a) < std::pair(high, b);
  });
  const std::uint32_t left = build(first, half);
  const std::uint32_t right = build(first + half, count - half);
  nodes_[place].first = left;
  nodes_[place].second = right;
  return place;
}

}  // namespace stope::metric
