#include "framework/report/draw/sketches.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "framework/report/draw/grid_picture.hpp"
#include "framework/report/draw/sketch_table.hpp"

namespace stope::report {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

OccupancyGrid grid_of(int width, int height, std::uint8_t value) {
  OccupancyGrid grid;
  grid.frame.width = width;
  grid.frame.height = height;
  grid.cells.assign(grid.frame.size(), value);
  return grid;
}

TEST(OccupancySketch, ShowsEachCellWithTheLowestRowAtTheBottom) {
  OccupancyGrid grid = grid_of(3, 2, OccupancyGrid::kUnknown);
  grid.cells[grid.frame.place({0, 0})] = OccupancyGrid::kFree;
  grid.cells[grid.frame.place({2, 1})] = OccupancyGrid::kOccupied;
  const Sketch sketch = sketch_of(grid);
  ASSERT_TRUE(sketch.raster);
  const Picture& picture = sketch.raster->picture;
  ASSERT_EQ(picture.width, 3);
  ASSERT_EQ(picture.height, 2);
  const Colour free = picture.at(0, 1), occupied = picture.at(2, 0), unknown = picture.at(1, 0);
  EXPECT_EQ(free, (Colour{255, 255, 255, 255}));
  EXPECT_LT(occupied[0], unknown[0]);
  EXPECT_LT(unknown[0], free[0]);
  for (const auto& [x, y] : {std::pair{0, 0}, {1, 1}, {2, 1}}) EXPECT_EQ(picture.at(x, y), unknown);
  EXPECT_TRUE(sketch.raster->neutral);
}

TEST(OccupancySketch, ShrinksALargeGridToMeanColours) {
  // Left half free, right half occupied, 3000 cells wide: at 1400 pixels, the halves stay halves.
  OccupancyGrid grid = grid_of(3000, 10, OccupancyGrid::kFree);
  for (int row = 0; row < 10; ++row) {
    for (int column = 1500; column < 3000; ++column)
      grid.cells[grid.frame.place({column, row})] = OccupancyGrid::kOccupied;
  }
  const Sketch sketch = sketch_of(grid);
  const Picture& picture = sketch.raster->picture;
  EXPECT_EQ(picture.width, kLongestSide);
  EXPECT_EQ(picture.at(kLongestSide / 2 - 1, 0), (Colour{255, 255, 255, 255}));
  const Colour right = picture.at(kLongestSide / 2, 0);
  EXPECT_LT(right[0], 200);
  EXPECT_EQ(picture.at(kLongestSide - 1, picture.height - 1), right);
  EXPECT_NE(sketch.caption.find("50 % free, 50 % occupied, 0 % unknown"), std::string::npos);
}

TEST(OccupancySketch, EveryCellOfALargeGridBelongsToOnePixel) {
  GridFrame frame;
  frame.width = 4216;
  frame.height = 2591;
  const Blocks blocks(frame);
  EXPECT_EQ(blocks.column_begin(0), 0);
  EXPECT_EQ(blocks.column_begin(blocks.picture_width), frame.width);
  EXPECT_EQ(blocks.row_begin(blocks.picture_height - 1), 0);
  EXPECT_EQ(blocks.row_end(0), frame.height);
  for (int y = 1; y < blocks.picture_height; ++y)
    EXPECT_EQ(blocks.row_end(y), blocks.row_begin(y - 1));
}

TEST(Sketches, BearGridsWithoutOrWithTooFewCells) {
  OccupancyGrid grid = grid_of(100, 100, 0);
  grid.cells.resize(50);
  EXPECT_FALSE(sketch_of(grid).raster);
  EXPECT_FALSE(sketch_of(OccupancyGrid{}).raster);
  EXPECT_FALSE(sketch_of(ElevationGrid{}).raster);
  EXPECT_FALSE(sketch_of(DistanceGrid{}).raster);
  EXPECT_FALSE(sketch_of(LabelGrid{}).raster);
  EXPECT_FALSE(sketch_of(RegionMap{}).raster);
  EXPECT_FALSE(sketch_of(PointCloud{}).raster);
}

TEST(ElevationSketch, IsTransparentWhereTheHeightIsNotKnown) {
  ElevationGrid grid;
  grid.frame.width = 2;
  grid.frame.height = 1;
  grid.cells = {12.0F, static_cast<float>(kNaN)};
  const Sketch sketch = sketch_of(grid);
  EXPECT_EQ(sketch.raster->picture.at(0, 0)[3], 255);
  EXPECT_EQ(sketch.raster->picture.at(1, 0)[3], 0);
  EXPECT_NE(sketch.caption.find("12 m to 12 m high"), std::string::npos) << sketch.caption;
}

// A ring of four nodes with one spur: two dead ends if the spur stands alone, one loop.
RoadGraph ring_with_spur() {
  RoadGraph graph;
  const std::vector<Vector2> places{{0, 0}, {100, 0}, {100, 100}, {0, 100}, {200, 0}};
  for (const Vector2& place : places) graph.nodes.push_back({0, place.x(), place.y(), kNaN});
  for (const auto& [from, to] : {std::pair{0, 1}, {1, 2}, {2, 3}, {0, 3}, {1, 4}}) {
    RoadEdge edge;
    edge.from = static_cast<std::uint32_t>(from);
    edge.to = static_cast<std::uint32_t>(to);
    edge.first_vertex = static_cast<std::uint32_t>(graph.vertices.size());
    edge.vertex_count = 2;
    for (const int node : {from, to}) {
      const Vector2& place = places[static_cast<std::size_t>(node)];
      graph.vertices.push_back({place.x(), place.y(), kNaN, 5});
    }
    graph.edges.push_back(edge);
  }
  canonicalize(graph);
  return graph;
}

TEST(RoadGraphSketch, CountsLoopsAndDeadEnds) {
  const Sketch sketch = sketch_of(ring_with_spur());
  EXPECT_EQ(sketch.caption, "5 nodes, 5 edges, 500 m, 1 loop, 1 dead end");
  EXPECT_EQ(sketch.strokes.size(), 5U);
  int junctions = 0, dead_ends = 0;
  for (const Mark& mark : sketch.marks) {
    junctions += mark.style == "junction" ? 1 : 0;
    dead_ends += mark.style == "dead-end" ? 1 : 0;
  }
  EXPECT_EQ(junctions, 1);
  EXPECT_EQ(dead_ends, 1);
}

TEST(RoadGraphSketch, LeavesOutEdgesThatPointNowhere) {
  RoadGraph graph = ring_with_spur();
  graph.edges[0].from = 77;
  graph.edges[1].first_vertex = 1'000'000;
  graph.edges[2].vertex_count = 4'000'000'000U;
  EXPECT_EQ(sketch_of(graph).strokes.size(), 2U);
}

TEST(PointSketch, CoversThePointsAndPassesOverWhatIsNotFinite) {
  PointCloud cloud;
  cloud.origin = Vector3(500'000, 4'000'000, 100);
  for (int i = 0; i < 100; ++i) {
    for (int j = 0; j < 50; ++j)
      cloud.points.push_back({static_cast<float>(i), static_cast<float>(j), 0.0F});
  }
  cloud.points.push_back({std::numeric_limits<float>::infinity(), 0, 0});
  cloud.points.push_back({0, static_cast<float>(kNaN), 0});
  const Sketch sketch = sketch_of(cloud);
  ASSERT_TRUE(sketch.raster);
  const GridFrame& frame = sketch.raster->frame;
  EXPECT_TRUE(frame.cell_at(500'050, 4'000'025));
  EXPECT_NEAR(frame.width * frame.resolution, 99, 8);
  EXPECT_NEAR(frame.height * frame.resolution, 49, 5);
}

// Rooms of 4 x 4 cells, one column of walls between them.
RegionMap rooms(int columns, int rows) {
  RegionMap map;
  map.labels.frame.width = columns * 5;
  map.labels.frame.height = rows * 5;
  map.labels.cells.dense().assign(map.labels.frame.size(), 0);
  for (int i = 0; i < columns * rows; ++i) {
    const int column = i % columns, row = i / columns;
    Region region;
    region.id = static_cast<std::uint64_t>(i) + 1;
    region.x = 5 * column + 2, region.y = 5 * row + 2.5, region.area = 20;
    map.regions.push_back(region);
    for (int y = 0; y < 5; ++y) {
      for (int x = 0; x < 4; ++x)
        map.labels.cells.dense()[map.labels.frame.place({5 * column + x, 5 * row + y})] = i + 1;
    }
    // Neighbours through the wall; those above and below touch.
    if (column > 0) {
      map.adjacency.push_back(static_cast<std::uint32_t>(i - 1));
      map.adjacency.push_back(static_cast<std::uint32_t>(i));
    }
  }
  return map;
}

TEST(RegionSketch, NeighboursDifferInColourAndHaveOutlines) {
  const RegionMap map = rooms(6, 4);
  const Sketch sketch = sketch_of(map);
  EXPECT_EQ(sketch.caption, "24 regions, 20 neighbouring pairs, 480 m²");
  ASSERT_TRUE(sketch.raster);
  const Picture& picture = sketch.raster->picture;
  ASSERT_EQ(picture.width, 30 * 8);
  // The middle of a cell, and the side of a square at a region's border.
  const auto cell = [&](int column, int row) {
    return picture.at(8 * column + 4, 8 * (20 - 1 - row) + 4);
  };
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 6; ++column) {
      const Colour own = cell(5 * column + 1, 5 * row + 2);
      if (column > 0) {
        EXPECT_NE(own, cell(5 * column - 3, 5 * row + 2));
      }
      if (row > 0) {
        EXPECT_NE(own, cell(5 * column + 1, 5 * row - 3));
      }
      const Colour border = picture.at(8 * 5 * column, 8 * (20 - 1 - (5 * row + 2)) + 4);
      EXPECT_LT(border[0] + border[1] + border[2], own[0] + own[1] + own[2]);
      EXPECT_EQ(cell(5 * column + 4, 5 * row + 2)[3], 0);  // the wall
    }
  }
  EXPECT_EQ(sketch.marks.size(), 24U);
  EXPECT_EQ(sketch.strokes.size(), 20U);
}

TEST(RegionSketch, BearsManyRegionsAndPairsThatPointNowhere) {
  RegionMap map = rooms(400, 300);
  map.adjacency.insert(map.adjacency.end(), {7, 4'000'000'000U, 120'000, 3});
  map.labels.cells.dense()[0] = 2'000'000'000;
  map.labels.cells.dense()[1] = -5;
  const Sketch sketch = sketch_of(map);
  EXPECT_EQ(sketch.raster->picture.width, kLongestSide);
  EXPECT_EQ(sketch.marks.size(), 120'000U);
}

TEST(SketchTable, DrawsEveryPictureTypeAndNoOther) {
  EXPECT_TRUE(sketch_function(OccupancyGrid::kType));
  EXPECT_TRUE(sketch_function(RoadGraph::kType));
  EXPECT_TRUE(sketch_function(Measures::kType));
  EXPECT_FALSE(sketch_function(ImuSample::kType));
  EXPECT_FALSE(sketch_function("acme/Sector@1"));
  const OccupancyGrid grid = grid_of(2, 2, 0);
  EXPECT_EQ(sketch_function(OccupancyGrid::kType)(&grid).kind, "Occupancy grid");
}

}  // namespace
}  // namespace stope::report
