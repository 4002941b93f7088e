// Problem: hundreds of scans see the same ground again and again; the map wants each place once.
// Idea: voxels live in hash tables, one for each of sixteen parts of space (chosen by hash). A part
// takes its points in the order they come, so sums are the same however many threads share the
// parts; at the end all voxels are put in order of their place.
// Cost: O(1) a point (each part glances at every point's key), O(v log v) at the end; 40 bytes a
// voxel.
#include "plugins/map/voxel_filter.hpp"

#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace stope::map {
namespace {

constexpr std::uint64_t kOutside = std::numeric_limits<std::uint64_t>::max();
constexpr double kReach = 1 << 20;  // voxels from the origin, along each axis

std::uint64_t axis_key(double cells) {
  return static_cast<std::uint64_t>(static_cast<std::int64_t>(std::floor(cells)) + (1 << 20));
}

std::uint64_t key_of(const Point3f& point, double voxel) {
  const double x = point.x / voxel, y = point.y / voxel, z = point.z / voxel;
  const bool inside = std::abs(x) < kReach && std::abs(y) < kReach && std::abs(z) < kReach;
  return inside ? axis_key(z) << 42 | axis_key(y) << 21 | axis_key(x) : kOutside;
}

double corner(std::uint64_t key, int shift, double voxel) {
  const auto cells = static_cast<std::int64_t>((key >> shift) & ((1U << 21) - 1)) - (1 << 20);
  return static_cast<double>(cells) * voxel;
}

std::uint64_t hash_of(std::uint64_t key) {
  key ^= key >> 33;
  key *= 0xff51afd7ed558ccdULL;
  key ^= key >> 33;
  key *= 0xc4ceb9fe1a85ec53ULL;
  return key ^ (key >> 33);
}

}  // namespace

VoxelFilter::VoxelFilter(double voxel) : voxel_(voxel) {}

VoxelFilter::Voxel& VoxelFilter::Shard::find(std::uint64_t key, std::uint64_t hash) {
  if (2 * (voxels.size() + 1) > slots.size()) grow();
  const std::size_t mask = slots.size() - 1;
  for (std::size_t slot = hash & mask;; slot = (slot + 1) & mask) {
    if (slots[slot] == 0) {
      voxels.push_back({});
      voxels.back().key = key;
      slots[slot] = static_cast<std::uint32_t>(voxels.size());
      return voxels.back();
    }
    if (voxels[slots[slot] - 1].key == key) return voxels[slots[slot] - 1];
  }
}

void VoxelFilter::Shard::grow() {
  slots.assign(std::max<std::size_t>(1024, 2 * slots.size()), 0);
  const std::size_t mask = slots.size() - 1;
  for (std::size_t i = 0; i < voxels.size(); ++i) {
    std::size_t slot = hash_of(voxels[i].key) & mask;
    while (slots[slot] != 0) slot = (slot + 1) & mask;
    slots[slot] = static_cast<std::uint32_t>(i + 1);
  }
}

std::size_t VoxelFilter::add(std::span<const VoxelPoint> points) {
  keys_.resize(points.size());
  tbb::parallel_for(std::size_t{0}, points.size(), [&](std::size_t i) {
    keys_[i] = points[i].used ? key_of(points[i].position, voxel_) : kOutside;
  });
  tbb::parallel_for(std::size_t{0}, kShards, [&](std::size_t part) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (keys_[i] == kOutside) continue;
      const std::uint64_t hash = hash_of(keys_[i]);
      if (hash >> 60 != part) continue;
      const VoxelPoint& point = points[i];
      Voxel& voxel = shards_[part].find(keys_[i], hash);
      voxel.offset[0] += static_cast<float>(point.position.x - corner(voxel.key, 0, voxel_));
      voxel.offset[1] += static_cast<float>(point.position.y - corner(voxel.key, 21, voxel_));
      voxel.offset[2] += static_cast<float>(point.position.z - corner(voxel.key, 42, voxel_));
      voxel.intensity += point.intensity;
      ++voxel.count;
      auto& votes = voxel.labels[point.label < voxel.labels.size() ? point.label : 0];
      if (votes < std::numeric_limits<std::uint16_t>::max()) ++votes;
    }
  });
  std::size_t outside = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
    outside += points[i].used && keys_[i] == kOutside ? 1 : 0;
  return outside;
}

PointCloud VoxelFilter::finish(const Vector3& origin, bool with_intensity, bool with_label) {
  std::vector<Voxel> voxels;
  for (Shard& shard : shards_) {
    voxels.insert(voxels.end(), shard.voxels.begin(), shard.voxels.end());
    shard = {};
  }
  tbb::parallel_sort(voxels.begin(), voxels.end(),
                     [](const Voxel& a, const Voxel& b) { return a.key < b.key; });
  PointCloud cloud;
  cloud.origin = origin;
  cloud.points.resize(voxels.size());
  if (with_intensity) cloud.intensity.resize(voxels.size());
  if (with_label) cloud.label.resize(voxels.size());
  for (std::size_t i = 0; i < voxels.size(); ++i) {
    const Voxel& voxel = voxels[i];
    const auto mean = [&](int axis) {
      return static_cast<float>(corner(voxel.key, 21 * axis, voxel_) +
                                static_cast<double>(voxel.offset[static_cast<std::size_t>(axis)]) /
                                    voxel.count);
    };
    cloud.points[i] = {mean(0), mean(1), mean(2)};
    if (with_intensity) cloud.intensity[i] = voxel.intensity / static_cast<float>(voxel.count);
    if (with_label) {
      const auto most = std::max_element(voxel.labels.begin(), voxel.labels.end());
      cloud.label[i] = static_cast<std::uint8_t>(most - voxel.labels.begin());
    }
  }
  return cloud;
}

}  // namespace stope::map
