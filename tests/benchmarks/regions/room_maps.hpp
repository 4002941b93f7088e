#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "stope/payloads/occupancy_grid.hpp"
#include "stope/payloads/region_map.hpp"

namespace stope::benchmarks {

/// A map with labelled rooms.
struct RoomMap {
  std::string name;
  std::filesystem::path picture, truth;
};

/// The maps of a folder that have a picture of their true rooms, of the same size, by name.
std::vector<RoomMap> room_maps(const std::filesystem::path& folder);

/// White (at least 250 of 255) is free, the rest is not.
OccupancyGrid read_rooms(const std::filesystem::path& picture, double resolution);

/// One cell for each square of `factor` x `factor`: free if at least half of its cells are.
OccupancyGrid coarser(const OccupancyGrid& grid, std::int32_t factor);

/// Paints regions in colours of their own, for people to look at.
void write_picture(const RegionMap& map, const std::filesystem::path& file);

}  // namespace stope::benchmarks
