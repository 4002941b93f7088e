#pragma once

#include <optional>

#include "plugins/source/synthetic_pit/street_network.hpp"

namespace stope::source {

/// What a road must keep to be built.
struct NetworkRules {
  double half_size = 0;            ///< the map reaches this far from (0, 0)
  double margin = 8.0;             ///< metres to the map's border
  double berm_width = 3.4;         ///< metres, foot to foot
  double wall_slope = 1.9;         ///< rise over run of the steepest bank between two roads
  double repose_slope = 0.75;      ///< rise over run of tipped rock
  double smallest_radius = 16.0;   ///< metres, of a centre line
  double grade = 0.09;             ///< steepest, rise over run
  double junction_spacing = 55.0;  ///< metres along a street
  double fillet = 9.0;             ///< metres, radius of a junction's corners
  /// Metres between a spline's controls such that a right angle keeps the smallest radius.
  double leg() const { return 1.45 * smallest_radius; }
};

/// A road somebody would like to build, with what it is tied to.
struct Proposal {
  Street street;
  std::optional<Attachment> start, end;
  std::optional<DeadEnd> dead_end;  ///< at the street's end
};

/// Whether the proposal can be built without touching what is there: it stays on the map, is not
/// bent or inclined too much, and between it and every other road (and between its own far parts)
/// there is room for two berms and a bank that bridges the difference in height. Near a junction
/// the roads that meet there are excused.
bool buildable(const StreetNetwork& network, const Proposal& proposal, const NetworkRules& rules);

/// Adds a proposal that is buildable.
void build(StreetNetwork& network, Proposal proposal);

}  // namespace stope::source
