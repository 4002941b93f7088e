#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "stope/payloads/point_cloud.hpp"

namespace stope::map {

/// A point ready to be put into its voxel.
struct VoxelPoint {
  Point3f position;  ///< metres, relative to the cloud's origin
  float intensity = 0;
  std::uint8_t label = 0;
  bool used = false;  ///< false: to be passed over
};

/// Joins points into one for each cubic voxel: their mean place and intensity, and the label most
/// of them have (the lowest of equals). The same bytes on any number of threads.
class VoxelFilter {
 public:
  /// `voxel` in metres, above 0.
  explicit VoxelFilter(double voxel);
  /// Adds points in their order, in parallel over parts of space. Returns how many lie too far from
  /// the origin (a million voxels) and are left out.
  std::size_t add(std::span<const VoxelPoint> points);
  /// One point for each voxel, ordered by height, then y, then x of the voxel. Leaves the filter
  /// empty. Intensities and labels as asked for.
  PointCloud finish(const Vector3& origin, bool with_intensity, bool with_label);

 private:
  struct Voxel {
    std::uint64_t key = 0;
    std::array<float, 3> offset{};  // sum, from the voxel's lower corner
    float intensity = 0;            // sum
    std::uint32_t count = 0;
    std::array<std::uint16_t, 6> labels{};
  };
  /// A part of space with a hash table of its own.
  struct Shard {
    std::vector<Voxel> voxels;
    std::vector<std::uint32_t> slots;  // place in voxels + 1; 0: free
    Voxel& find(std::uint64_t key, std::uint64_t hash);
    void grow();
  };
  static constexpr std::size_t kShards = 16;

  double voxel_;
  std::array<Shard, kShards> shards_;
  std::vector<std::uint64_t> keys_;  // of the points being added
};

}  // namespace stope::map
