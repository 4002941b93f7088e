#include "plugins/topology/free_circles.hpp"

#include <gtest/gtest.h>

#include <random>

namespace stope::topology {
namespace {

TEST(FreeCircles, NeverSayMoreThanTheTrueDistance) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> anywhere(0, 100);
  for (int round = 0; round < 50; ++round) {
    std::vector<LinePoint> obstacles;
    for (int i = 0; i < 20; ++i) obstacles.push_back({anywhere(random), anywhere(random), 0});
    const auto nearest = [&](const LinePoint& place) {
      double least = 1e9;
      for (const LinePoint& obstacle : obstacles)
        least = std::min(least, distance_between(place, obstacle));
      return least;
    };
    FreeCircles circles;
    for (int i = 0; i < 30; ++i) {
      LinePoint centre{anywhere(random), anywhere(random), 0};
      centre.distance = nearest(centre);
      circles.add(centre);
      EXPECT_GE(circles.known_distance(centre), centre.distance);
    }
    for (int i = 0; i < 100; ++i) {
      const LinePoint place{anywhere(random), anywhere(random), 0};
      EXPECT_LE(circles.known_distance(place), nearest(place) + 1e-9);
    }
  }
}

TEST(FreeCircles, TwoThatDoNotMeetLeaveALineBetweenThemUnknown) {
  FreeCircles apart, touching;
  const LinePoint west{0, 0, 5}, east{20, 0, 5}, middle{10, 0, 8};
  for (const LinePoint& place : {west, east}) apart.add(place), touching.add(place);
  touching.add(middle);
  EXPECT_FALSE(apart.free_between(west, east, 0.2));
  EXPECT_TRUE(touching.free_between(west, east, 0.2));
  EXPECT_FALSE(touching.free_between(west, east, 0.9));
}

}  // namespace
}  // namespace stope::topology
