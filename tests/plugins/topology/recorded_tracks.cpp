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

}  // namespace stope::topology
