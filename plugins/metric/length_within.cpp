// Problem: how much of one set of lines lies within a distance of another, without the error of
// samples.
// Idea: what is within b of a straight piece is a stadium, which is convex, so a line crosses it in
// one interval: the hull of its intervals in the stadium's rectangle and two discs. The union of
// intervals over all near pieces is the answer for a piece.
#include "plugins/metric/length_within.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace stope::metric {
namespace {

// Parameters along a line, 0 at its begin and 1 at its end; empty if low > high.
struct Interval {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();
  void join(const Interval& other) {
    if (other.low > other.high) return;
    low = std::min(low, other.low);
    high = std::max(high, other.high);
  }
};

// Where begin + t * span is within `radius` of `centre`.
Interval in_disc(const Vector2& begin, const Vector2& span, const Vector2& centre, double radius) {
  const double square = span.squaredNorm();
  const double middle = (centre - begin).dot(span) / square;
  const double aside = (begin + middle * span - centre).squaredNorm();
  const double rest = radius * radius - aside;
  if (rest < 0) return {};
  const double half = std::sqrt(rest / square);
  return {middle - half, middle + half};
}

// Where low <= value + t * slope <= high.
Interval in_slab(double value, double slope, double low, double high) {
  constexpr double kAll = std::numeric_limits<double>::infinity();
  if (slope == 0) return value >= low && value <= high ? Interval{-kAll, kAll} : Interval{};
  const double a = (low - value) / slope, b = (high - value) / slope;
  return {std::min(a, b), std::max(a, b)};
}

Interval in_stadium(const Vector2& begin, const Vector2& span, const GraphLines::Piece& piece,
                    double radius) {
  Interval result = in_disc(begin, span, piece.a, radius);
  result.join(in_disc(begin, span, piece.b, radius));
  const Vector2 core = piece.b - piece.a;
  const double length = core.norm();
  if (length > 0) {
    const Vector2 along = core / length, across(-along.y(), along.x());
    const Vector2 offset = begin - piece.a;
    const Interval lengthwise = in_slab(offset.dot(along), span.dot(along), 0, length);
    const Interval crosswise = in_slab(offset.dot(across), span.dot(across), -radius, radius);
    result.join(
        {std::max(lengthwise.low, crosswise.low), std::min(lengthwise.high, crosswise.high)});
  }
  return {std::max(result.low, 0.0), std::min(result.high, 1.0)};
}

double covered(std::vector<Interval>& intervals) {
  std::sort(intervals.begin(), intervals.end(), [](const Interval& a, const Interval& b) {
    return std::pair(a.low, a.high) < std::pair(b.low, b.high);
  });
  double sum = 0, reached = 0;
  for (const Interval& interval : intervals) {
    sum += std::max(0.0, interval.high - std::max(interval.low, reached));
    reached = std::max(reached, interval.high);
  }
  return sum;
}

}  // namespace

double length_within(const GraphLines& lines, const GraphLines& other, double buffer) {
  double sum = 0;
  std::vector<Interval> intervals;
  for (const GraphLines::Piece& piece : lines.pieces()) {
    const Vector2 span = piece.b - piece.a;
    if (span.squaredNorm() == 0) continue;
    intervals.clear();
    other.visit_touching(box_of(piece.a, piece.b).widened(buffer), [&](const auto& near) {
      const Interval interval = in_stadium(piece.a, span, near, buffer);
      if (interval.low <= interval.high) intervals.push_back(interval);
    });
    sum += covered(intervals) * span.norm();
  }
  return sum;
}

}  // namespace stope::metric
