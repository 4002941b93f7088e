#include "stope/codec.hpp"

#include <gtest/gtest.h>

#include "stope/digest.hpp"
#include "stope/layout.hpp"
#include "stope/payloads.hpp"

namespace stope {
namespace {

template <class T>
T round_trip(const T& value) {
  ByteBuffer buffer;
  encode(value, buffer);
  ByteReader reader(buffer.bytes());
  T copy;
  decode(copy, reader);
  EXPECT_EQ(reader.remaining(), 0U);
  EXPECT_EQ(digest_of(copy), digest_of(value));
  return copy;
}

TEST(Codec, BringsAScanBack) {
  LidarScan scan;
  scan.points = {{1, 2, 3}, {4, 5, 6}};
  scan.time_offset = {-100, 0};
  const LidarScan copy = round_trip(scan);
  EXPECT_EQ(copy.points, scan.points);
  EXPECT_EQ(copy.time_offset, scan.time_offset);
}

TEST(Codec, BringsNestedStructsAndOptionalsBack) {
  OccupancyGrid grid;
  grid.frame = {2, 1, 0.5, {1, 2, 0.25}};
  grid.cells = {0, 255};
  grid.changed = ChangedWindow{1, 0, 1, 1, 7};
  const OccupancyGrid copy = round_trip(grid);
  EXPECT_EQ(copy.frame, grid.frame);
  ASSERT_TRUE(copy.changed);
  EXPECT_EQ(copy.changed->since, 7U);
}

TEST(Codec, PointsAreWrittenInOnePiece) {
  EXPECT_TRUE(is_flat<Point3f>());
  EXPECT_TRUE(is_flat<StampedPose>());
  EXPECT_TRUE(is_flat<RoadVertex>());
  EXPECT_TRUE(is_flat<RoadEdge>());
  EXPECT_FALSE(is_flat<ArtefactFile>());
}

/// What encode() writes, by counting it.
template <class T>
void expect_size(const T& value) {
  ByteCounter counter;
  encode(value, counter);
  EXPECT_EQ(encoded_size(value), counter.count()) << T::kType;
}

TEST(Codec, KnowsTheSizeOfWhatItWouldWrite) {
  expect_size(LidarScan{});
  LidarScan scan;
  scan.points = {{1, 2, 3}, {4, 5, 6}};
  scan.time_offset = {-100, 0};
  expect_size(scan);
  OccupancyGrid grid;
  grid.cells = {0, 255, 7};
  expect_size(grid);
  grid.changed = ChangedWindow{1, 0, 1, 1, 7};
  expect_size(grid);
  Artefact artefact;
  artefact.files = {{"yaml", {1, 2, 3}}, {"ppm", {}}};
  expect_size(artefact);
  Measures measures;
  measures.names = {"recall", ""};
  measures.values = {1, 2};
  expect_size(measures);
  Submap submap;
  submap.finished = true;
  expect_size(submap);
  RoadGraph roads;
  roads.nodes.resize(3);
  roads.edges.resize(2);
  expect_size(roads);
  RegionMap map;
  map.regions.resize(2);
  map.semantics = {"kitchen", ""};
  map.labels.cells = std::vector<std::int32_t>{1, 2, 0};
  expect_size(map);
}

TEST(Codec, RefusesBytesThatEndEarly) {
  PointCloud cloud;
  cloud.points.resize(10);
  ByteBuffer buffer;
  encode(cloud, buffer);
  for (std::size_t size = 0; size < buffer.bytes().size(); ++size) {
    ByteReader reader(std::span(buffer.bytes()).first(size));
    PointCloud copy;
    EXPECT_THROW(decode(copy, reader), Error) << size;
  }
}

TEST(Codec, RefusesALengthThatCannotBe) {
  ByteBuffer buffer;
  encode<std::uint64_t>(std::uint64_t{1} << 60, buffer);
  ByteReader reader(buffer.bytes());
  std::vector<double> numbers;
  EXPECT_THROW(decode(numbers, reader), Error);
}

TEST(Layout, NamesEveryFieldAndKind) {
  EXPECT_EQ(layout_text<Pose2>(), "{x:f8,y:f8,yaw:f8,#24}");
  EXPECT_NE(layout_hash<PointCloud>(), layout_hash<LidarScan>());
}

}  // namespace
}  // namespace stope
