#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "plugins/metric/lattice_space.hpp"

namespace stope::metric {

/// Lengths of shortest ways in free space, any angle, exact to rounding: free space is the union of
/// closed free cells, so that two cells that touch at a corner are connected. What was seen from a
/// corner is kept for the next question.
class Geodesics {
 public:
  static constexpr double kUnreachable = std::numeric_limits<double>::infinity();

  explicit Geodesics(const FreeCells& cells);

  /// Metres between two places of the map frame, taken to the nearest 1/1024 of a cell;
  /// kUnreachable if there is no way, none if one of them is not in free space.
  std::optional<double> between(const Vector2& from, const Vector2& to);

 private:
  struct Seen {
    std::uint32_t corner;
    double distance;  // parts of a cell
  };
  struct State {
    double travelled = 0, to_goal = -1;  // to_goal < 0: the goal is not seen
    std::uint64_t question = 0, goal_question = 0;
  };
  std::optional<LatticePoint> to_lattice(const Vector2& place) const;
  const std::vector<Seen>& seen_from(std::uint32_t corner);
  double search(LatticePoint from, LatticePoint to);

  GridFrame frame_;
  LatticeSpace space_;
  std::vector<std::vector<Seen>> seen_;
  std::vector<std::uint8_t> looked_;
  std::vector<State> states_;
  std::uint64_t question_ = 0;
};

}  // namespace stope::metric
