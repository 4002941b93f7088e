#include "plugins/planner/reeds_shepp_words.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "plugins/planner/dubins_words.hpp"
#include "stope/random.hpp"

namespace stope::planner {
namespace {

constexpr double kPi = std::numbers::pi;

double shortest(const Pose2& from, const Pose2& to, double radius = 1) {
  return reeds_shepp_words(from, to, radius).at(0).total * radius;
}

void expect_pose(const Pose2& pose, const Pose2& expected, double within) {
  EXPECT_NEAR(pose.x, expected.x, within);
  EXPECT_NEAR(pose.y, expected.y, within);
  EXPECT_NEAR(std::remainder(pose.yaw - expected.yaw, 2 * kPi), 0, within);
}

TEST(ReedsSheppWords, KnownLengths) {
  EXPECT_NEAR(shortest({0, 0, 0}, {10, 0, 0}), 10, 1e-9);
  EXPECT_NEAR(shortest({0, 0, 0}, {-10, 0, 0}), 10, 1e-9);
  EXPECT_NEAR(shortest({0, 0, 0}, {1, 1, kPi / 2}), kPi / 2, 1e-9);
  EXPECT_NEAR(shortest({0, 0, 0}, {12, 12, kPi / 2}, 12), 12 * kPi / 2, 1e-9);
  // Turning round on the spot: three arcs of a third of a half turn each (Reeds and Shepp 1990).
  EXPECT_NEAR(shortest({0, 0, 0}, {0, 0, kPi}), kPi, 1e-9);
}

TEST(ReedsSheppWords, EveryWordArrives) {
  Random random(1);
  for (int i = 0; i < 300; ++i) {
    const Pose2 from{random.uniform(-50, 50), random.uniform(-50, 50), random.uniform(-9, 9)};
    const Pose2 to{random.uniform(-50, 50), random.uniform(-50, 50), random.uniform(-9, 9)};
    for (const auto& words : {reeds_shepp_words(from, to, 12), dubins_words(from, to, 12)}) {
      ASSERT_FALSE(words.empty());
      double before = 0;
      for (const SteeringWord& word : words) {
        const DriveCurve curve = curve_of(word, from, 12);
        expect_pose(curve.end(), to, 1e-4);
        EXPECT_NEAR(curve.length(), word.total * 12, 1e-6);
        EXPECT_GE(word.total, before);
        before = word.total;
      }
    }
  }
}

// Whatever way of arcs and straights leads somewhere, the shortest word is no longer. Ways of the
// shapes that the 48 words have, with short arcs, are often the shortest themselves: were one of
// the formulas wrong or left out, this would find it.
TEST(ReedsSheppWords, NoOtherWayIsShorter) {
  const char* shapes[] = {"LSL", "LSR", "LRL", "LRLR", "LRSL", "LRSR", "LSRL", "RSRL", "LRSLR"};
  Random random(2);
  int equal = 0;
  for (int i = 0; i < 40000; ++i) {
    const std::string shape = shapes[random.below(9)];
    const bool mirror = random.below(2) == 1;
    DriveCurve way{{0, 0, 0}, {}};
    for (const char steer : shape) {
      const double bend = steer == 'S' ? 0 : ((steer == 'L') != mirror ? 1 : -1);
      const double length = steer == 'S'           ? random.uniform(0, 3)
                            : random.below(3) == 0 ? kPi / 2
                                                   : random.uniform(0, kPi / 2);
      way.pieces.push_back({random.below(2) == 1 ? -length : length, bend, bend});
    }
    const double best = shortest(way.start, way.end());
    ASSERT_LE(best, way.length() + 1e-6) << shape;
    if (best > way.length() - 1e-6) ++equal;
  }
  EXPECT_GT(equal, 1000);
}

TEST(ReedsSheppWords, TheWayBackIsAsLongAsTheWayThere) {
  Random random(3);
  for (int i = 0; i < 1000; ++i) {
    const Pose2 to{random.uniform(-6, 6), random.uniform(-6, 6), random.uniform(-kPi, kPi)};
    EXPECT_NEAR(shortest({0, 0, 0}, to), shortest(to, {0, 0, 0}), 1e-6);
  }
}

TEST(DubinsWords, NeverReverseAndAreNoShorter) {
  Random random(4);
  for (int i = 0; i < 1000; ++i) {
    const Pose2 to{random.uniform(-6, 6), random.uniform(-6, 6), random.uniform(-kPi, kPi)};
    const auto words = dubins_words({0, 0, 0}, to, 1);
    ASSERT_FALSE(words.empty());
    EXPECT_GE(words[0].total, shortest({0, 0, 0}, to) - 1e-6);
    for (const CurvePiece& piece : curve_of(words[0], {0, 0, 0}, 1).pieces)
      EXPECT_GE(piece.length, 0);
  }
}

}  // namespace
}  // namespace stope::planner
