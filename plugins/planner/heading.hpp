#pragma once

#include <cmath>

namespace stope::planner {

/// A heading, or a turn, as its cosine and sine, which many ask for and which are dear to take
/// anew.
class Heading {
 public:
  explicit Heading(double yaw) : cos_(std::cos(yaw)), sin_(std::sin(yaw)) {}
  /// A turn by some radians: by few, a series to the last digits is quicker.
  static Heading turn(double by) {
    if (std::abs(by) > 0.3) return Heading(by);
    const double square = by * by;
    return {1 - square / 2 * (1 - square / 12 * (1 - square / 30 * (1 - square / 56))),
            by * (1 - square / 6 * (1 - square / 20 * (1 - square / 42 * (1 - square / 72))))};
  }
  double cosine() const { return cos_; }
  double sine() const { return sin_; }
  Heading turned(const Heading& by) const {
    return {cos_ * by.cos_ - sin_ * by.sin_, sin_ * by.cos_ + cos_ * by.sin_};
  }
  Heading turned(double by) const { return turned(turn(by)); }

 private:
  Heading(double cosine, double sine) : cos_(cosine), sin_(sine) {}
  double cos_, sin_;
};

}  // namespace stope::planner
