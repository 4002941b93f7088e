#pragma once

#include "plugins/topology/line_network.hpp"

namespace stope::topology {

/// Removes all parts of lines that are nearer to an obstacle cell's centre than `least_distance`
/// cells; what is left of a line ends in a node of its own.
void drop_narrow(LineNetwork& network, double least_distance);

}  // namespace stope::topology
