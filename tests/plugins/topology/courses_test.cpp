#include "plugins/topology/courses.hpp"

#include <gtest/gtest.h>

namespace stope::topology {
namespace {

std::vector<LinePoint> straight(double from, double to) {
  std::vector<LinePoint> points;
  const double step = from < to ? 1 : -1;
  for (double x = from; x != to + step; x += step) points.push_back({x, 0, 10 - x});
  return points;
}

TEST(Courses, AreReadInBothDirections) {
  Courses courses(false);
  const CourseId there = courses.add(straight(2, 5)), back = backwards(there);
  EXPECT_EQ(courses.view(back).copy(), straight(5, 2));
  EXPECT_EQ(courses.front(back), courses.back(there));
  EXPECT_EQ(courses.length(back), 3);
  EXPECT_EQ(courses.least_distance(there), 5);
  EXPECT_NE(courses.name(there), courses.name(back));
}

TEST(Courses, ThatAreJoinedOrCutAgainAreTheSame) {
  Courses courses(false);
  const CourseId left = courses.add(straight(0, 4)), right = courses.add(straight(9, 4));
  const CourseId whole = courses.joined({left, backwards(right)});
  EXPECT_EQ(courses.view(whole).copy(), straight(0, 9));
  EXPECT_EQ(courses.joined({left, backwards(right)}), whole);
  EXPECT_NE(courses.joined({right, backwards(left)}), whole);
  const CourseId part = courses.part(backwards(whole), 2, 5);
  EXPECT_EQ(courses.view(part).copy(), straight(7, 5));
  EXPECT_EQ(courses.part(backwards(whole), 2, 5), part);
  EXPECT_EQ(courses.part(whole, 0, 10), whole);
}

TEST(Courses, RememberOneNumberForEachDirection) {
  Courses courses(false);
  const CourseId course = courses.add(straight(0, 4));
  int asked = 0;
  const auto count = [&] { return ++asked; };
  EXPECT_EQ(courses.number(course, 1.5, count), 1);
  EXPECT_EQ(courses.number(course, 1.5, count), 1);
  EXPECT_EQ(courses.number(backwards(course), 1.5, count), 2);
  EXPECT_EQ(courses.number(course, 2.5, count), 3);
}

// A place that has become free is given to another course; what was made of the old one must not be
// found for it.
TEST(Courses, AreForgottenWithWhatWasMadeOfThem) {
  Courses courses(false);
  const CourseId lasting = courses.add(straight(0, 3));
  const CourseId kept = courses.joined({lasting, courses.add(straight(3, 6))});
  const std::int64_t name = courses.name(kept);
  std::vector<std::int64_t> names;
  for (int round = 0; round < 2000; ++round) {
    const CourseId other = courses.add(straight(3, 5 + round % 7));
    const CourseId made = courses.joined({lasting, other});
    ASSERT_EQ(courses.view(made).copy(), straight(0, 5 + round % 7));
    names.push_back(courses.name(other));
    courses.forget_unused({lasting, kept});
  }
  EXPECT_EQ(courses.view(kept).copy(), straight(0, 6));
  EXPECT_EQ(courses.name(kept), name);
  std::sort(names.begin(), names.end());
  EXPECT_EQ(std::unique(names.begin(), names.end()), names.end());
  EXPECT_LT(courses.add(straight(0, 1)), 4000);  // of 4001 made most are gone
}

}  // namespace
}  // namespace stope::topology
