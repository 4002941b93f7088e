#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "stope/payloads/occupancy_grid.hpp"
#include "stope/payloads/point_cloud.hpp"

namespace stope {

/// A local map that a few consecutive scans built, rigid in itself; its pose is what a pose graph
/// corrects. Grid and cloud are in the submap's own frame; either may be empty.
struct Submap {
  static constexpr std::string_view kType = "stope/Submap@1";
  std::uint64_t id = 0;
  Pose T_map_submap;  ///< at creation; a PoseGraph node of the same id holds the corrected one
  Quaternion attitude{1.0, 0, 0, 0};      ///< of the IMU at creation
  std::vector<std::uint64_t> scans;       ///< indices of the items in it
  std::vector<Pose> T_submap_scan;        ///< as long as scans
  std::vector<float> rotation_histogram;  ///< bins over half a turn; empty if not computed
  OccupancyGrid grid;
  PointCloud cloud;
  bool finished = false;
  static constexpr void fields(auto& s, auto&& visit) {
    visit("id", s.id);
    visit("T_map_submap", s.T_map_submap);
    visit("attitude", s.attitude);
    visit("scans", s.scans);
    visit("T_submap_scan", s.T_submap_scan);
    visit("rotation_histogram", s.rotation_histogram);
    visit("grid", s.grid);
    visit("cloud", s.cloud);
    visit("finished", s.finished);
  }
};

}  // namespace stope
