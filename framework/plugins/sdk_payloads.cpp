#include "framework/plugins/sdk_payloads.hpp"

#include "stope/payloads.hpp"

namespace stope {
namespace {

template <class... Payloads>
std::vector<const PayloadType*> types_of() {
  return {&payload_type<Payloads>()...};
}

}  // namespace

const std::vector<const PayloadType*>& sdk_payloads() {
  static const std::vector<const PayloadType*> types =
      types_of<Artefact, DistanceGrid, ElevationGrid, ImuSample, LabelGrid, LidarScan, LineSet,
               Measures, NavFix, OccupancyGrid, Path, PointCloud, PoseConstraint, PoseGraph,
               RegionMap, RoadGraph, StampedPose, Submap, Trajectory, VoxelMap>();
  return types;
}

const PayloadType* sdk_payload(std::string_view name, std::uint64_t layout) {
  for (const PayloadType* type : sdk_payloads())
    if (type->name == name && type->layout == layout) return type;
  return nullptr;
}

}  // namespace stope
