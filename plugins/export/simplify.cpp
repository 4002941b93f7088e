#include "plugins/export/simplify.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace stope::exports {
namespace {

double distance_to_segment(const RoadVertex& p, const RoadVertex& a, const RoadVertex& b) {
  const double dx = b.x - a.x, dy = b.y - a.y;
  const double square = dx * dx + dy * dy;
  const double t =
      square > 0 ? std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / square, 0.0, 1.0) : 0;
  return std::hypot(p.x - a.x - t * dx, p.y - a.y - t * dy);
}

}  // namespace

std::vector<std::size_t> simplify(std::span<const RoadVertex> line, double tolerance) {
  std::vector<bool> keep(line.size(), tolerance <= 0);
  std::vector<std::size_t> kept;
  if (line.empty()) return kept;
  keep.front() = keep.back() = true;
  std::vector<std::pair<std::size_t, std::size_t>> open;
  if (tolerance > 0) open.emplace_back(0, line.size() - 1);
  while (!open.empty()) {
    const auto [first, last] = open.back();
    open.pop_back();
    std::size_t farthest = first;
    double most = tolerance;
    for (std::size_t i = first + 1; i < last; ++i) {
      const double distance = distance_to_segment(line[i], line[first], line[last]);
      if (distance > most) most = distance, farthest = i;
    }
    if (farthest == first) continue;
    keep[farthest] = true;
    open.emplace_back(first, farthest);
    open.emplace_back(farthest, last);
  }
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (keep[i]) kept.push_back(i);
  }
  return kept;
}

}  // namespace stope::exports
