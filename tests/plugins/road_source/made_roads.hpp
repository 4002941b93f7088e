#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "stope/stope.hpp"

namespace stope::road_source {

/// A canonical graph of everything a road graph can hold: curves, loops, parallel roads, both ways
/// and one way, closed roads, lone nodes, heights here and there, attributes known and not.
RoadGraph made_roads(std::uint64_t seed, int nodes = 30, int edges = 60);

/// What road_source/nav2_route gives for a file with this text; its warnings go to `sentences`.
RoadGraph read_route(const std::string& text, std::vector<std::string>* sentences = nullptr,
                     double clearance = 0);

/// The sentence of the error that reading this text gives; empty if it gives none.
std::string read_error(const std::string& text);

}  // namespace stope::road_source
