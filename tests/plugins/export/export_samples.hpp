#pragma once

#include <string>

#include "stope/stope.hpp"

namespace stope::exports {

/// Three nodes; a straight road both ways, a curved one-way road, a closed road.
RoadGraph sample_roads();

/// The bytes of the artefact's file with this extension, as text. Throws if there is none.
std::string text_of(const Artefact& artefact, const std::string& extension);

}  // namespace stope::exports
