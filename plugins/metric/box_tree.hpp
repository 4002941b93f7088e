#pragma once

// Problem: of many small shapes in the plane, find those near a place without looking at all.
// Idea: a tree of bounding boxes, split at the median along the wider side; a search leaves out
// every box that is farther than the best found so far. Cost: O(n log n) to build, about O(log n) a
// search. The caller says what distance means, so points, segments and cells use one tree.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "stope/geometry.hpp"

namespace stope::metric {

/// An upright rectangle; metres or cells, as the tree's owner has it.
struct Box {
  Vector2 low = Vector2::Constant(std::numeric_limits<double>::infinity());
  Vector2 high = Vector2::Constant(-std::numeric_limits<double>::infinity());

  void grow(const Vector2& point) {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  void grow(const Box& box) {
    low = low.cwiseMin(box.low);
    high = high.cwiseMax(box.high);
  }
  Box widened(double margin) const {
    return {low - Vector2::Constant(margin), high + Vector2::Constant(margin)};
  }
  bool touches(const Box& box) const {
    return low.x() <= box.high.x() && box.low.x() <= high.x() && low.y() <= box.high.y() &&
           box.low.y() <= high.y();
  }
  double distance(const Box& box) const {
    const double x = std::max({0.0, box.low.x() - high.x(), low.x() - box.high.x()});
    const double y = std::max({0.0, box.low.y() - high.y(), low.y() - box.high.y()});
    return std::sqrt(x * x + y * y);
  }
};

inline Box box_of(const Vector2& a, const Vector2& b) {
  Box box;
  box.grow(a);
  box.grow(b);
  return box;
}

class BoxTree {
 public:
  struct Nearest {
    std::uint32_t item;
    double distance;
  };

  /// Items are numbered as `boxes` are ordered.
  explicit BoxTree(std::vector<Box> boxes);

  /// Calls visit(item) for each item whose box touches `box`, in an order that depends on the boxes
  /// alone.
  template <class Visit>
  void visit_touching(const Box& box, Visit&& visit) const {
    if (nodes_.empty()) return;
    std::vector<std::uint32_t> open{0};
    while (!open.empty()) {
      const Node& node = nodes_[open.back()];
      open.pop_back();
      if (!node.box.touches(box)) continue;
      if (node.count == 0) {
        open.push_back(node.second);
        open.push_back(node.first);
        continue;
      }
      for (std::uint32_t i = node.first; i < node.first + node.count; ++i)
        if (boxes_[order_[i]].touches(box)) visit(order_[i]);
    }
  }

  /// The item with the least distance_of(item), if that is at most `within`; of equal ones the
  /// first. `around` is what distances are taken from: no item may be nearer than its box is.
  template <class DistanceOf>
  std::optional<Nearest> nearest(const Box& around, double within, DistanceOf&& distance_of) const {
    std::optional<Nearest> best;
    double bound = within;
    if (nodes_.empty()) return best;
    std::vector<std::uint32_t> open{0};
    while (!open.empty()) {
      const Node& node = nodes_[open.back()];
      open.pop_back();
      if (node.box.distance(around) > bound) continue;
      if (node.count == 0) {
        const bool first_nearer =
            nodes_[node.first].box.distance(around) <= nodes_[node.second].box.distance(around);
        open.push_back(first_nearer ? node.second : node.first);
        open.push_back(first_nearer ? node.first : node.second);
        continue;
      }
      for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
        const std::uint32_t item = order_[i];
        const double distance = distance_of(item);
        if (distance > bound || (best && distance == bound && item > best->item)) continue;
        best = {item, distance};
        bound = distance;
      }
    }
    return best;
  }

 private:
  struct Node {
    Box box;
    std::uint32_t first = 0, second = 0;  // a leaf's first place in order_; else its two children
    std::uint32_t count = 0;              // of a leaf
  };
  std::uint32_t build(std::uint32_t first, std::uint32_t count);

  std::vector<Box> boxes_;
  std::vector<std::uint32_t> order_;
  std::vector<Node> nodes_;
};

}  // namespace stope::metric
