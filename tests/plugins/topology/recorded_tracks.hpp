#pragma once

#include <filesystem>
#include <vector>

#include "stope/geometry.hpp"
#include "stope/payloads/road_graph.hpp"

namespace stope::topology {

/// One vehicle's places, in the order it was there.
using RecordedTrack = std::vector<Vector2>;

/// The tracks of all scenarios/*.json of a folder, in the order of their names.
std::vector<RecordedTrack> read_tracks(const std::filesystem::path& folder);

/// Metres of all tracks, and of those the ones within the clearance of a road: in the union of the
/// discs along the graph.
struct TrackCover {
  double length = 0, within = 0;
};
TrackCover cover_of(const std::vector<RecordedTrack>& tracks, const RoadGraph& roads);

}  // namespace stope::topology
