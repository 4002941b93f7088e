// Problem: show where two road graphs, or two paths, part.
// Idea: walk along each line in steps of half a tolerance and ask a grid of buckets for a piece of
// the other drawing within the tolerance; a run of steps that have none is a part that differs.
// Cost: length / tolerance, times the pieces in a few buckets.
#include "framework/compare/report/line_difference.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <unordered_map>

namespace stope::report {
namespace {

class NearbyPieces {
 public:
  NearbyPieces(const Lines& lines, double tolerance) : tolerance_(tolerance) {
    for (const auto& line : lines)
      for (std::size_t i = 1; i < line.size(); ++i) add(line[i - 1], line[i]);
  }

  bool reach(const Vector2& point) const {
    const auto found = buckets_.find(key(bucket(point.x()), bucket(point.y())));
    if (found == buckets_.end()) return false;
    for (const std::uint32_t piece : found->second)
      if (distance(pieces_[piece], point) <= tolerance_) return true;
    return false;
  }

 private:
  struct Piece {
    Vector2 a, b;
  };

  static double distance(const Piece& piece, const Vector2& point) {
    const Vector2 along = piece.b - piece.a;
    const double square = along.squaredNorm();
    const double part =
        square > 0 ? std::clamp((point - piece.a).dot(along) / square, 0.0, 1.0) : 0.0;
    return (piece.a + part * along - point).norm();
  }
  double side() const { return 4 * tolerance_; }
  std::int64_t bucket(double value) const {
    return static_cast<std::int64_t>(std::floor(value / side()));
  }
  static std::uint64_t key(std::int64_t x, std::int64_t y) {
    return static_cast<std::uint64_t>(x) * 0x9e3779b97f4a7c15ULL + static_cast<std::uint64_t>(y);
  }

  // Into every bucket that a point within the tolerance may be in: steps of half a bucket along the
  // piece reach, with their surroundings, all of them.
  void add(const Vector2& a, const Vector2& b) {
    const auto number = static_cast<std::uint32_t>(pieces_.size());
    pieces_.push_back({a, b});
    const auto steps = static_cast<std::int64_t>(std::ceil((b - a).norm() / (side() / 2))) + 1;
    for (std::int64_t step = 0; step <= steps; ++step) {
      const double part = static_cast<double>(step) / static_cast<double>(steps);
      const Vector2 at = a + part * (b - a);
      for (std::int64_t dx = -1; dx <= 1; ++dx)
        for (std::int64_t dy = -1; dy <= 1; ++dy) {
          auto& held = buckets_[key(bucket(at.x()) + dx, bucket(at.y()) + dy)];
          if (held.empty() || held.back() != number) held.push_back(number);
        }
    }
  }

  double tolerance_;
  std::vector<Piece> pieces_;
  std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> buckets_;
};

// Cuts lines where what is near to the other's pieces ends.
void split(const Lines& lines, const NearbyPieces& others, double step, Lines& near, Lines& far) {
  for (const auto& line : lines) {
    if (line.size() < 2) continue;
    bool is_near = others.reach(line.front());
    std::vector<Vector2> part{line.front()};
    const auto end_part = [&](const Vector2& at) {
      part.push_back(at);
      (is_near ? near : far).push_back(std::move(part));
      part = {at};
    };
    for (std::size_t i = 1; i < line.size(); ++i) {
      const Vector2 from = line[i - 1], along = line[i] - from;
      const int steps = std::max(1, static_cast<int>(std::ceil(along.norm() / step)));
      for (int k = 1; k <= steps; ++k) {
        const Vector2 at = from + (static_cast<double>(k) / steps) * along;
        if (others.reach(at) != is_near) {
          end_part(from + ((k - 0.5) / steps) * along);
          is_near = !is_near;
        }
      }
      part.push_back(line[i]);
    }
    (is_near ? near : far).push_back(std::move(part));
  }
}

}  // namespace

Extent::Extent()
    : low(std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()),
      high(-low) {}

void Extent::include(const Lines& lines) {
  for (const auto& line : lines)
    for (const Vector2& point : line) {
      low = low.cwiseMin(point);
      high = high.cwiseMax(point);
    }
}

LineDifference line_difference(const Lines& first, const Lines& second, double tolerance) {
  const NearbyPieces of_first(first, tolerance), of_second(second, tolerance);
  LineDifference difference;
  Lines common_of_second;
  split(first, of_second, tolerance / 2, difference.common, difference.only_first);
  split(second, of_first, tolerance / 2, common_of_second, difference.only_second);
  return difference;
}

double length_of(const Lines& lines) {
  double length = 0;
  for (const auto& line : lines)
    for (std::size_t i = 1; i < line.size(); ++i) length += (line[i] - line[i - 1]).norm();
  return length;
}

double drawing_tolerance(double diagonal) {
  const double wanted = std::max(diagonal, 1e-3) / 500;
  const double power = std::pow(10.0, std::floor(std::log10(wanted)));
  for (const double round : {5.0, 2.0})
    if (round * power <= wanted) return round * power;
  return power;
}

}  // namespace stope::report
