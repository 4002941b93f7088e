#pragma once

#include <cstdint>
#include <vector>

#include "plugins/metric/lattice_space.hpp"

namespace stope::metric {

/// Whether the straight line between two points stays in free space. Free space is the union of
/// closed free cells: a line may run along an obstacle's side and through the point where two free
/// cells touch. Exact.
bool sees(const LatticeSpace& space, LatticePoint from, LatticePoint to);

/// The corners seen from a point at which a shortest way that comes from there can turn, by their
/// places in space.corners(). `turning_at`: the point is this corner itself, and only what a way
/// can reach that turns there is looked for. Exact.
std::vector<std::uint32_t> corners_seen(const LatticeSpace& space, LatticePoint from,
                                        const TurningCorner* turning_at = nullptr);

}  // namespace stope::metric
