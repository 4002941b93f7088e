#pragma once

#include <filesystem>
#include <vector>

#include "stope/geometry.hpp"

namespace stope::topology {

/// One vehicle's places, in the order it was there.
using RecordedTrack = std::vector<Vector2>;

/// The tracks of all scenarios/*.json of a folder, in the order of their names.
std::vector<RecordedTrack> read_tracks(const std::filesystem::path& folder);

}  // namespace stope::topology
