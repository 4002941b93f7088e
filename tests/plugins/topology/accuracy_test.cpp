#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <numbers>

#include "plugins/topology/extract_roads.hpp"
#include "tests/plugins/topology/graph_checks.hpp"
#include "tests/plugins/topology/test_grids.hpp"

namespace stope::topology {
namespace {

/// A network of straight roads of known centre lines and ends.
struct Network {
  std::string name;
  std::vector<Stretch> roads;
  std::vector<Point> ends, junctions;
  double half_width = 6;
};

constexpr double kSize = 200;

std::vector<Network> networks() {
  std::vector<Network> result;
  for (const double degrees : {0.0, 17.0, 45.0, 80.0}) {
    const double c = std::cos(degrees * 3.14159265358979 / 180),
                 s = std::sin(degrees * 3.14159265358979 / 180);
    const auto at = [&](double x, double y) {
      return Point{kSize / 2 + c * x - s * y, kSize / 2 + s * x + c * y};
    };
    const std::string suffix = " turned by " + std::to_string(static_cast<int>(degrees));
    result.push_back({"corridor" + suffix, {{at(-70, 0), at(70, 0)}}, {at(-70, 0), at(70, 0)}, {}});
    result.push_back({"cross" + suffix,
                      {{at(-70, 0), at(70, 0)}, {at(0, -70), at(0, 70)}},
                      {at(-70, 0), at(70, 0), at(0, -70), at(0, 70)},
                      {at(0, 0)}});
    result.push_back({"oblique cross" + suffix,
                      {{at(-70, 0), at(70, 0)}, {at(-40, -60), at(40, 60)}},
                      {at(-70, 0), at(70, 0), at(-40, -60), at(40, 60)},
                      {at(0, 0)}});
    result.push_back({"T" + suffix,
                      {{at(-70, 0), at(70, 0)}, {at(0, 0), at(0, 60)}},
                      {at(-70, 0), at(70, 0), at(0, 60)},
                      {at(0, 0)}});
    result.push_back({"ring with a spur" + suffix,
                      {{at(-40, -40), at(40, -40)},
                       {at(40, -40), at(40, 40)},
                       {at(40, 40), at(-40, 40)},
                       {at(-40, 40), at(-40, -40)},
                       {at(-40, -40), at(-70, -60)}},
                      {at(-70, -60)},
                      {at(-40, -40)}});
  }
  return result;
}

OccupancyGrid draw(const Network& network, double resolution, double rough, std::uint64_t seed) {
  return grid_where(kSize, kSize, resolution, [&](double x, double y) {
    const double wall = network.half_width + rough * roughness(x, y, 0.5, seed);
    return distance_to(network.roads, {x, y}) <= wall;
  });
}

/// Shares of the graph's length that lie within a distance of the true centre lines.
double share_within(const RoadGraph& roads, const Network& network, double distance) {
  double near = 0, all = 0;
  for (const RoadEdge& edge : roads.edges) {
    const auto line = roads.polyline(edge);
    for (std::size_t i = 1; i < line.size(); ++i) {
      const double step = std::hypot(line[i].x - line[i - 1].x, line[i].y - line[i - 1].y);
      const int parts = static_cast<int>(step / 0.1) + 1;
      for (int k = 0; k < parts; ++k) {
        const double part = (k + 0.5) / parts;
        const Point point{line[i - 1].x + part * (line[i].x - line[i - 1].x),
                          line[i - 1].y + part * (line[i].y - line[i - 1].y)};
        all += step / parts;
        if (distance_to(network.roads, point) <= distance) near += step / parts;
      }
    }
  }
  return near / all;
}

double farthest(const std::vector<Point>& truth, const std::vector<RoadNode>& found) {
  double worst = 0;
  for (const Point& end : truth) {
    double least = 1e9;
    for (const RoadNode& node : found)
      least = std::min(least, std::hypot(node.x - end.x, node.y - end.y));
    worst = std::max(worst, least);
  }
  return worst;
}

std::vector<RoadNode> junctions_of(const RoadGraph& roads) {
  std::vector<RoadNode> result;
  for (const int degree : {3, 4})
    for (const RoadNode& node : nodes_of_degree(roads, degree)) result.push_back(node);
  return result;
}

class Accuracy : public testing::TestWithParam<std::tuple<double, double>> {};

void expect_centre_lines_to_their_ends(
    double resolution, double rough,
    const std::function<RoadGraph(const OccupancyGrid& grid)>& extract) {
  std::uint64_t seed = 0;
  for (const Network& network : networks()) {
    const OccupancyGrid grid = draw(network, resolution, rough, ++seed);
    const RoadGraph roads = extract(grid);
    EXPECT_EQ(nodes_of_degree(roads, 1).size(), network.ends.size()) << network.name;
    EXPECT_EQ(junctions_of(roads).size(), network.junctions.size()) << network.name;
    // A road's end is the centre of its last full-width circle.
    EXPECT_LE(farthest(network.ends, nodes_of_degree(roads, 1)), 1.0 + 2 * rough) << network.name;
    EXPECT_LE(farthest(network.junctions, junctions_of(roads)), 2.0 + rough) << network.name;
    EXPECT_GE(share_within(roads, network, 1.0), 0.95) << network.name;
    if (rough == 0) {
      EXPECT_NEAR(roads.edges[0].width, 2 * network.half_width, 1.0) << network.name;
    }
  }
}

TEST_P(Accuracy, VoronoiFollowsCentreLinesToTheirEnds) {
  const auto [resolution, rough] = GetParam();
  expect_centre_lines_to_their_ends(
      resolution, rough, [](const OccupancyGrid& grid) { return voronoi_roads(grid, {}, {}); });
}

TEST_P(Accuracy, SkeletonFollowsCentreLinesToTheirEnds) {
  const auto [resolution, rough] = GetParam();
  for (const auto pruning :
       {SkeletonParams::Pruning::kChordResidual, SkeletonParams::Pruning::kLambda})
    expect_centre_lines_to_their_ends(resolution, rough, [&](const OccupancyGrid& grid) {
      return skeleton_roads(grid, {}, {}, {pruning});
    });
}

/// How much further the second of the two sides of a road is from a place than the first, by
/// looking at every obstacle cell: the second is the nearest one seen more than 60 degrees away.
double off_medial_axis(const OccupancyGrid& grid, Point place) {
  std::vector<std::pair<double, Point>> seen;
  double least = 1e9;
  for (std::int32_t row = 0; row < grid.frame.height; ++row) {
    for (std::int32_t column = 0; column < grid.frame.width; ++column) {
      if (grid.cells[grid.frame.place({column, row})] == OccupancyGrid::kFree) continue;
      const Vector2 centre = grid.frame.centre({column, row});
      const Point to{centre.x() - place.x, centre.y() - place.y};
      const double distance = std::hypot(to.x, to.y);
      if (distance > 20) continue;
      seen.push_back({distance, {to.x / distance, to.y / distance}});
      least = std::min(least, distance);
    }
  }
  Point first{};
  for (const auto& [distance, direction] : seen)
    if (distance == least) first = direction;
  double second = 1e9;
  for (const auto& [distance, direction] : seen)
    if (first.x * direction.x + first.y * direction.y < 0.5) second = std::min(second, distance);
  return second - least;
}

TEST(Accuracy, SkeletonStaysOnTheMedialAxisUpToItsJunctions) {
  constexpr double kResolution = 0.5;
  for (const Network& network : networks()) {
    if (network.name.find("turned by 17") == std::string::npos) continue;
    const OccupancyGrid grid = draw(network, kResolution, 0, 1);
    ExtractionParams params;
    params.simplify = 0.05;
    params.medial_lines = true;
    const RoadGraph roads = skeleton_roads(grid, params, {}, {});
    const auto junctions = junctions_of(roads);
    std::size_t looked_at = 0;
    for (std::size_t i = 0; i < roads.vertices.size(); i += 2) {
      const RoadVertex& vertex = roads.vertices[i];
      if (std::any_of(junctions.begin(), junctions.end(), [&](const RoadNode& node) {
            return std::hypot(node.x - vertex.x, node.y - vertex.y) < 1.5 * network.half_width;
          }))
        continue;
      ++looked_at;
      EXPECT_LE(off_medial_axis(grid, {vertex.x, vertex.y}), 1.5 * kResolution)
          << network.name << " at " << vertex.x << ", " << vertex.y;
    }
    EXPECT_GT(looked_at, 4U) << network.name;
  }
}

TEST_P(Accuracy, WatershedOfPartsFollowsCentreLinesToTheirEnds) {
  const auto [resolution, rough] = GetParam();
  expect_centre_lines_to_their_ends(resolution, rough, [](const OccupancyGrid& grid) {
    return watershed_part_roads(grid, {}, {}, {});
  });
}

TEST_P(Accuracy, WatershedFollowsCentreLinesOfLoops) {
  const auto [resolution, rough] = GetParam();
  std::uint64_t seed = 100;
  for (const Network& network : networks()) {
    const OccupancyGrid grid = draw(network, resolution, rough, ++seed);
    const RoadGraph roads = watershed_roads(grid, {});
    EXPECT_TRUE(nodes_of_degree(roads, 1).empty());
    if (!network.name.starts_with("ring")) {
      EXPECT_TRUE(roads.edges.empty()) << network.name << " has no hole, so no watershed";
      continue;
    }
    EXPECT_EQ(roads.edges.size(), 1U);
    EXPECT_GE(share_within(roads, network, 1.0), 0.95) << network.name;
  }
}

INSTANTIATE_TEST_SUITE_P(Resolutions, Accuracy,
                         testing::Combine(testing::Values(0.25, 0.5), testing::Values(0.0, 0.8)));

TEST(Accuracy, ASideRoadThatBendsSoonMeetsWhereItWouldGoStraightOn) {
  // A road of 15 m along x; a second leaves it at a right angle and bends by 75 degrees after 8 m.
  std::vector<Stretch> roads{{{20, 60}, {180, 60}}, {{100, 60}, {100, 68}}};
  Point last{100, 68};
  constexpr double kRadius = 18;
  for (int degrees = 5; degrees <= 75; degrees += 5) {
    const double angle = degrees * 3.14159265358979 / 180;
    const Point next{100 + kRadius * (1 - std::cos(angle)), 68 + kRadius * std::sin(angle)};
    roads.push_back({last, next});
    last = next;
  }
  roads.push_back({last, {last.x + 60 * std::sin(1.309), last.y + 60 * std::cos(1.309)}});
  const OccupancyGrid grid = draw({"bend", roads, {}, {}, 7.5}, 0.5, 0, 1);
  const RoadGraph graph = voronoi_roads(grid, {}, {});
  ASSERT_EQ(graph.edges.size(), 3U);
  for (std::uint32_t node = 0; node < graph.nodes.size(); ++node) {
    const auto ends = std::count_if(graph.edges.begin(), graph.edges.end(), [&](const auto& edge) {
      return edge.from == node || edge.to == node;
    });
    if (ends == 3) {
      EXPECT_LT(std::hypot(graph.nodes[node].x - 100, graph.nodes[node].y - 60), 3);
    }
  }
}

TEST(Accuracy, ARoadGoesOnRoundItsBendWhereAnotherJoinsItStraighter) {
  // An arch of 25 m radius; at its top a road leaves obliquely, in line with half of the arch
  // rather than with what comes from the other side.
  for (const double heading : {0.9, 1.2, std::numbers::pi - 1.2}) {
    std::vector<Stretch> roads{{{75, 10}, {75, 60}}, {{125, 60}, {125, 10}}};
    Point last{75, 60};
    for (int degrees = 175; degrees >= 0; degrees -= 5) {
      const double angle = degrees * std::numbers::pi / 180;
      const Point next{100 + 25 * std::cos(angle), 60 + 25 * std::sin(angle)};
      roads.push_back({last, next});
      last = next;
    }
    roads.push_back({{100, 85}, {100 + 70 * std::cos(heading), 85 + 70 * std::sin(heading)}});
    const RoadGraph graph = voronoi_roads(draw({"arch", roads, {}, {}, 7.5}, 0.5, 0, 1), {}, {});
    const auto junctions = junctions_of(graph);
    ASSERT_EQ(junctions.size(), 1U) << heading;
    EXPECT_LT(std::hypot(junctions[0].x - 100, junctions[0].y - 85), 2.5) << heading;
  }
}

TEST(Accuracy, ASquareFaceEndsTheRoadWhereItsFullWidthEnds) {
  const OccupancyGrid grid = grid_where(
      100, 40, 0.25, [](double x, double y) { return x > 10 && x < 90 && y > 13 && y < 27; });
  const RoadGraph roads = voronoi_roads(grid, {}, {});
  ASSERT_EQ(roads.nodes.size(), 2U);
  EXPECT_NEAR(roads.nodes[0].x, 17, 1.0);
  EXPECT_NEAR(roads.nodes[0].y, 20, 1.0);
  EXPECT_NEAR(roads.nodes[1].x, 83, 1.0);
  EXPECT_NEAR(roads.nodes[1].y, 20, 1.0);
}

TEST(Accuracy, ABayIsNoRoadAndAStubIs) {
  const auto with_side_road = [](double depth) {
    return grid_where(120, 60, 0.25, [=](double x, double y) {
      return (x > 10 && x < 110 && y > 14 && y < 26) ||
             (x > 55 && x < 65 && y > 20 && y < 26 + depth);
    });
  };
  EXPECT_EQ(voronoi_roads(with_side_road(3), {}, {}).edges.size(), 1U);
  EXPECT_EQ(voronoi_roads(with_side_road(20), {}, {}).edges.size(), 3U);
}

TEST(Accuracy, NarrowRoadsAreDropped) {
  const OccupancyGrid grid = grid_where(120, 60, 0.25, [](double x, double y) {
    return (x > 10 && x < 50 && y > 20 && y < 40) || (x > 70 && x < 110 && y > 20 && y < 40) ||
           (y > 28.5 && y < 31.5 && x > 40 && x < 80);
  });
  ExtractionParams params;
  params.min_clearance = 1.0;
  EXPECT_EQ(betti_of(voronoi_roads(grid, params, {})).pieces, 1);
  params.min_clearance = 2.0;
  EXPECT_EQ(betti_of(voronoi_roads(grid, params, {})).pieces, 2);
}

}  // namespace
}  // namespace stope::topology
