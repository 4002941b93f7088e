#pragma once

#include <map>
#include <memory>

#include "plugins/source/synthetic_pit/world.hpp"

namespace stope::source {

/// A pit small enough for tests.
inline PitParameters small_pit() {
  PitParameters parameters;
  parameters.size = 440;
  parameters.benches = 2;
  parameters.dead_ends = 5;
  parameters.connectors = 1;
  parameters.azimuths = 360;
  return parameters;
}

/// A yard at the bottom of a pit.
inline PitParameters yard() {
  PitParameters parameters;
  parameters.size = 150;
  parameters.benches = 2;
  parameters.road_width = 10;
  parameters.dead_ends = 3;
  return parameters;
}

}  // namespace stope::source
