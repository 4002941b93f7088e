#pragma once

#include <cstdint>

#include "plugins/source/synthetic_pit/checkpoint.hpp"
#include "plugins/source/synthetic_pit/network_rules.hpp"
#include "plugins/source/synthetic_pit/pit_parameters.hpp"
#include "plugins/source/synthetic_pit/pit_shape.hpp"
#include "plugins/source/synthetic_pit/street_network.hpp"

namespace stope::source {

/// A mine as planned: the shape of the ground before roads, and the roads.
struct Layout {
  PitShape shape;
  StreetNetwork network;
  NetworkRules rules;
};

/// Plans a mine: a ring road around the pit, a loop on its floor, one or two ramps between them,
/// then dead ends and connecting roads wherever a random proposal can be built. Throws Error if the
/// parameters leave no room for the loop on the floor.
Layout plan_layout(const PitParameters& parameters, std::uint64_t seed,
                   const Checkpoint& checkpoint = never_stop);

}  // namespace stope::source
