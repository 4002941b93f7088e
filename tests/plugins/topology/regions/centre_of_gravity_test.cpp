#include <gtest/gtest.h>

#include <cmath>

#include "plugins/topology/regions/region_shape.hpp"
#include "tests/plugins/topology/test_grids.hpp"

namespace stope::topology {
namespace {

TEST(CentreOfGravity, OfATriangleIsTheMeanOfItsCorners) {  // eq. 2
  const ShapePoint centre = centre_of_gravity({{0, 0}, {9, 0}, {0, 6}}, {0, 0});
  EXPECT_DOUBLE_EQ(centre.x, 3);
  EXPECT_DOUBLE_EQ(centre.y, 2);
}

TEST(CentreOfGravity, DoesNotDependOnThePivotOrTheDirection) {  // eqs. 3 to 5
  // A rectangle of 4 x 6 with a triangle of base 4 and height 3 on top.
  const double y = (24.0 * 3 + 6.0 * 7) / 30;
  for (const HullPoint pivot : {HullPoint{0, 0}, HullPoint{2, 3}, HullPoint{-50, 17}}) {
    const ShapePoint centre = centre_of_gravity({{0, 0}, {4, 0}, {4, 6}, {2, 9}, {0, 6}}, pivot);
    EXPECT_NEAR(centre.x, 2, 1e-12);
    EXPECT_NEAR(centre.y, y, 1e-12);
    const ShapePoint backward = centre_of_gravity({{0, 6}, {2, 9}, {4, 6}, {4, 0}, {0, 0}}, pivot);
    EXPECT_NEAR(backward.y, y, 1e-12);
  }
}

TEST(CentreOfGravity, WithoutAreaIsTheMeanOfTheCorners) {
  const ShapePoint centre = centre_of_gravity({{1, 1}, {5, 3}}, {1, 1});
  EXPECT_DOUBLE_EQ(centre.x, 3);
  EXPECT_DOUBLE_EQ(centre.y, 2);
}

/// The shape of the free cells of a grid as one region.
RegionShape shape_where(const std::function<bool(double, double)>& free) {
  ExtractionParams params;
  params.min_obstacle_area = 0;
  const Ground ground(grid_where(200, 160, 1, free), params);
  RegionCells regions = without_regions(ground);
  for (std::size_t i = 0; i < regions.size(); ++i)
    regions.data()[i] = ground.free(static_cast<CellIndex>(i)) ? 1 : 0;
  return shape_of(ground, regions, {1, {0, 1}, {0, 1}}, 1, all_tiles(ground));
}

TEST(Axes, OfAnEllipseAreItsSemiAxes) {
  const double yaw = 0.4, c = std::cos(yaw), s = std::sin(yaw);
  const Axes axes = shape_where([&](double x, double y) {
                      const double u = (c * (x - 100) + s * (y - 80)) / 60;
                      const double v = (-s * (x - 100) + c * (y - 80)) / 25;
                      return u * u + v * v <= 1;
                    }).axes();
  EXPECT_NEAR(axes.major, 60, 0.3);
  EXPECT_NEAR(axes.minor, 25, 0.3);
  EXPECT_NEAR(axes.yaw, yaw, 0.005);
}

TEST(Axes, OfARectangleHaveItsMoments) {
  // The variance of a side of length l is l^2 / 12, and a semi-axis is twice its root.
  const RegionShape shape =
      shape_where([](double x, double y) { return x > 40 && x < 160 && y > 60 && y < 90; });
  EXPECT_EQ(shape.cells, 120 * 30);
  EXPECT_NEAR(shape.axes().major, 120 / std::sqrt(3.0), 1e-9);
  EXPECT_NEAR(shape.axes().minor, 30 / std::sqrt(3.0), 1e-9);
  EXPECT_EQ(shape.hull, (std::vector<HullPoint>{{40, 60}, {159, 60}, {159, 89}, {40, 89}}));
}

TEST(RegionShape, TwoAddedAreTheShapeOfBoth) {
  const auto left = [](double x, double y) { return x > 20 && x < 60 && y > 60 && y < 90; };
  const auto right = [](double x, double y) { return x > 60 && x < 110 && y > 40 && y < 70; };
  RegionShape sum = shape_where(left);
  sum += shape_where(right);
  const RegionShape both =
      shape_where([&](double x, double y) { return left(x, y) || right(x, y); });
  EXPECT_EQ(sum.cells, both.cells);
  EXPECT_EQ(sum.hull, both.hull);
  EXPECT_DOUBLE_EQ(sum.axes().major, both.axes().major);
}

}  // namespace
}  // namespace stope::topology
