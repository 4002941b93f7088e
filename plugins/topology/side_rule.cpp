#include <cmath>

#include "plugins/topology/dividing_lines.hpp"

namespace stope::topology {

bool SideRule::divided_within(OutlineEdge a, OutlineEdge b, std::int32_t outline) const {
  if (kind_ == Kind::kParts)
    return turns_->between(a, b, outlines_->list[static_cast<std::size_t>(outline)], outline);
  const Outlines::Place first = outlines_->place[static_cast<std::size_t>(a)];
  const Outlines::Place second = outlines_->place[static_cast<std::size_t>(b)];
  const double dx = first.column - second.column, dy = first.row - second.row;
  const double chord = std::sqrt(dx * dx + dy * dy);
  return ways_->between(a, b, outline) - chord >= least_;
}

}  // namespace stope::topology
