#include "tests/plugins/topology/recorded_tracks.hpp"

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

namespace stope::topology {
namespace {

/// Numbers are there one by one or each in a list of its own.
void read_numbers(const nlohmann::json& list, std::vector<double>& out) {
  for (const auto& entry : list) {
    if (entry.is_array()) {
      read_numbers(entry, out);
    } else {
      out.push_back(entry.get<double>());
    }
  }
}

/// Whether a place lies within the clearance of some point of an edge.
bool covered(const RoadGraph& roads, const Vector2& place) {
  for (const RoadEdge& edge : roads.edges) {
    const auto line = roads.polyline(edge);
    for (std::size_t i = 1; i < line.size(); ++i) {
      const Vector2 a(line[i - 1].x, line[i - 1].y), b(line[i].x, line[i].y);
      const double farthest = std::max(line[i - 1].clearance, line[i].clearance);
      const double length = (b - a).norm();
      if ((place - a).norm() > farthest + length) continue;
      const int parts = static_cast<int>(length / 0.5) + 1;
      for (int k = 0; k <= parts; ++k) {
        const double share = static_cast<double>(k) / parts;
        const double clearance =
            line[i - 1].clearance + share * (line[i].clearance - line[i - 1].clearance);
        if ((a + share * (b - a) - place).norm() <= clearance) return true;
      }
    }
  }
  return false;
}

}  // namespace

std::vector<RecordedTrack> read_tracks(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.path().extension() == ".json") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  std::vector<RecordedTrack> tracks;
  for (const auto& file : files) {
    std::ifstream in(file);
    const auto scenario = nlohmann::json::parse(in);
    for (const auto& vehicle : scenario.at("TrajSegmentInfo")) {
      std::vector<double> x, y;
      read_numbers(vehicle.at("states").at("x"), x);
      read_numbers(vehicle.at("states").at("y"), y);
      RecordedTrack track;
      for (std::size_t i = 0; i < std::min(x.size(), y.size()); ++i) track.emplace_back(x[i], y[i]);
      tracks.push_back(std::move(track));
    }
  }
  return tracks;
}

TrackCover cover_of(const std::vector<RecordedTrack>& tracks, const RoadGraph& roads) {
  TrackCover cover;
  for (const RecordedTrack& track : tracks) {
    for (std::size_t i = 1; i < track.size(); ++i) {
      const double step = (track[i] - track[i - 1]).norm();
      cover.length += step;
      if (covered(roads, 0.5 * (track[i] + track[i - 1]))) cover.within += step;
    }
  }
  return cover;
}

}  // namespace stope::topology
