#include "plugins/topology/check_frame.hpp"

#include <fmt/format.h>

#include <cmath>

#include "stope/error.hpp"

namespace stope::topology {
namespace {

constexpr double kFinest = 1e-3, kCoarsest = 1e3;  // metres a cell

}  // namespace

void check_frame(const GridFrame& frame, std::size_t cells, std::string_view name) {
  if (frame.width <= 0 || frame.height <= 0)
    throw Error(fmt::format("the {} grid is empty ({} x {} cells); a road graph needs a map", name,
                            frame.width, frame.height));
  if (cells != frame.size())
    throw Error(fmt::format("the {} grid says {} x {} cells but holds {}; its source is at fault",
                            name, frame.width, frame.height, cells));
  if (!(frame.resolution > 0) || !std::isfinite(frame.resolution))
    throw Error(
        fmt::format("the {} grid has a resolution of {} m a cell; it must be a positive number",
                    name, frame.resolution));
  if (frame.resolution < kFinest || frame.resolution > kCoarsest)
    throw Error(
        fmt::format("the {} grid has a resolution of {} m a cell; expected are {} m to {} m: check "
                    "the unit of its source",
                    name, frame.resolution, kFinest, kCoarsest));
  if (!std::isfinite(frame.origin.x) || !std::isfinite(frame.origin.y) ||
      !std::isfinite(frame.origin.yaw))
    throw Error(
        fmt::format("the {} grid's origin is ({}, {}, {}); it must be three finite numbers: x and "
                    "y in metres, yaw in radians",
                    name, frame.origin.x, frame.origin.y, frame.origin.yaw));
}

}  // namespace stope::topology
