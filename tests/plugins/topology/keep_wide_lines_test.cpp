#include "plugins/topology/keep_wide_lines.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "tests/plugins/topology/test_grids.hpp"

namespace stope::topology {
namespace {

constexpr double kLambda = 8.0;
using Place = std::pair<double, double>;

/// Dividing lines between sides, as a network, and which of their steps are narrow.
struct Lines {
  explicit Lines(const OccupancyGrid& grid)
      : space(make_free_space(grid, {})),
        edges(space.width(), space.height()),
        outlines(trace_outlines(space, edges, 0, 3)) {
    find_nearest_outline(space, outlines, edges);
    const SideRule rule = SideRule::between_sides(outlines);
    const std::vector<CellIndex> corners = find_dividing_lines(space, outlines, rule, edges);
    LineTracer tracer(space, outlines, edges, courses, kLambda);
    lines = trace_lines(tracer, corners);
    for (const TracedLine& line : lines) {
      const bool one_outline = outlines.of_edge[static_cast<std::size_t>(line.sides[0])] ==
                               outlines.of_edge[static_cast<std::size_t>(line.sides[1])];
      narrow.push_back(one_outline ? line.narrow : std::vector<StepRange>());
    }
  }
  bool is_narrow(std::size_t line, std::size_t step) const {
    return std::any_of(narrow[line].begin(), narrow[line].end(), [&](const StepRange& stretch) {
      return stretch.begin <= static_cast<std::int32_t>(step) &&
             static_cast<std::int32_t>(step) < stretch.end;
    });
  }
  Place place(std::size_t line, std::size_t step) const {
    const LinePoint& point = courses.view(lines[line].course)[step + 1];
    return {point.x, point.y};
  }

  FreeSpace space;
  EdgeGrid edges;
  Outlines outlines;
  Courses courses{false};
  std::vector<TracedLine> lines;
  std::vector<std::vector<StepRange>> narrow;
};

/// For each step the corners at its ends, and whether it is wide.
struct Step {
  CellIndex from, to;
  bool wide;
};

/// How many wide steps hang together with a corner, without a step that is left out.
int wide_beyond(const std::vector<Step>& steps, const std::multimap<CellIndex, std::size_t>& at,
                CellIndex start, std::size_t left_out) {
  std::set<CellIndex> seen{start};
  std::set<std::size_t> wide;
  std::vector<CellIndex> open{start};
  while (!open.empty()) {
    const CellIndex corner = open.back();
    open.pop_back();
    const auto [begin, end] = at.equal_range(corner);
    for (auto next = begin; next != end; ++next) {
      if (next->second == left_out) continue;
      const Step& step = steps[next->second];
      if (step.wide) wide.insert(next->second);
      for (const CellIndex other : {step.from, step.to})
        if (seen.insert(other).second) open.push_back(other);
    }
  }
  return static_cast<int>(wide.size());
}

// The truth: a step stays if it is wide, or if there are wide steps on both of its sides when it is
// taken out.
TEST(KeepWideLines, KeepsWhatIsWideAndWhatLiesBetween) {
  int narrow_kept = 0, taken_off = 0, cut_lines = 0;
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    // Blocks, or rough walls with narrow passages between wide places.
    Lines map(seed % 2 ? random_grid(48, 40, 0.85, 4, seed)
                       : grid_where(70, 60, 1.0, [=](double x, double y) {
                           return roughness(x, y, 1.0 / 16, seed) +
                                      0.6 * roughness(x, y, 1.0 / 5, seed + 1) >
                                  -0.1;
                         }));
    std::vector<Step> steps;
    std::multimap<CellIndex, std::size_t> at;
    std::vector<Place> places;
    for (std::size_t i = 0; i < map.lines.size(); ++i) {
      const auto& corners = map.lines[i].corners;
      for (std::size_t k = 0; k + 1 < corners.size(); ++k) {
        at.emplace(corners[k], steps.size());
        at.emplace(corners[k + 1], steps.size());
        steps.push_back({corners[k], corners[k + 1], !map.is_narrow(i, k)});
        places.push_back(map.place(i, k));
      }
    }
    std::set<Place> wanted, unwanted;
    for (std::size_t i = 0; i < steps.size(); ++i) {
      const bool between = wide_beyond(steps, at, steps[i].from, i) > 0 &&
                           wide_beyond(steps, at, steps[i].to, i) > 0;
      (steps[i].wide || between ? wanted : unwanted).insert(places[i]);
      narrow_kept += !steps[i].wide && between ? 1 : 0;
    }
    LineNetwork network = to_network(list_of(map.lines), map.courses);
    keep_wide_lines(network, map.narrow, 0);
    std::set<Place> kept;
    for (const Line& line : network.lines) {
      const CourseView points = network.points(line);
      ASSERT_GE(points.size(), 2U);
      for (const LinePoint& point : points.copy()) kept.emplace(point.x, point.y);
      const LinePoint& from = network.nodes[static_cast<std::size_t>(line.from)].point;
      const LinePoint& to = network.nodes[static_cast<std::size_t>(line.to)].point;
      EXPECT_EQ(points.front(), from);
      EXPECT_EQ(points.back(), to);
      ++cut_lines;
    }
    for (const Place& place : wanted)
      EXPECT_TRUE(kept.contains(place))
          << "seed " << seed << ": " << place.first << ", " << place.second << " is missing";
    for (const Place& place : unwanted) {
      if (wanted.contains(place)) continue;
      EXPECT_FALSE(kept.contains(place))
          << "seed " << seed << ": " << place.first << ", " << place.second << " is left";
      ++taken_off;
    }
  }
  EXPECT_GT(narrow_kept, 100);
  EXPECT_GT(taken_off, 1000);
  EXPECT_GT(cut_lines, 100);
}

/// Of a chain of lines along y = 0, one after the other, each with so many steps.
LineNetwork chain(Courses& courses, const std::vector<int>& steps) {
  LineNetwork network(courses);
  network.nodes.push_back({{0, 0, 1}, false});
  for (const int count : steps) {
    const double start = network.nodes.back().point.x;
    std::vector<LinePoint> points{network.nodes.back().point};
    for (int k = 0; k < count; ++k) points.push_back({start + k + 0.5, 0, 1.0 + 0.01 * start});
    points.push_back({start + count, 0, 1});
    network.nodes.push_back({points.back(), false});
    const auto to = static_cast<std::int32_t>(network.nodes.size()) - 1;
    const CourseId course = courses.add(points);
    network.lines.push_back({to - 1, to, course, courses.length(course)});
  }
  return network;
}

TEST(KeepWideLines, LeavesOutFewWideStepsBehindANarrowPart) {
  for (const int few : {4, 5}) {
    Courses courses(false);
    // 20 wide steps, 10 narrow ones, 5 wide ones, 3 narrow ones.
    LineNetwork network = chain(courses, {20, 18});
    keep_wide_lines(network, {{}, {{0, 10}, {15, 18}}}, few);
    ASSERT_EQ(network.lines.size(), 1U);
    const CourseView points = network.points(network.lines[0]);
    EXPECT_EQ(points.front().x, 0);
    EXPECT_EQ(points.back().x, few == 4 ? 34.5 : 20);
  }
}

TEST(KeepWideLines, KeepsTheMostOfAPieceHoweverFewTheyAre) {
  Courses courses(false);
  LineNetwork network = chain(courses, {20});
  keep_wide_lines(network, {{{0, 4}, {7, 12}, {14, 20}}}, 10);
  ASSERT_EQ(network.lines.size(), 1U);
  EXPECT_EQ(network.points(network.lines[0]).front().x, 4.5);
  EXPECT_EQ(network.points(network.lines[0]).back().x, 6.5);
}

TEST(KeepWideLines, LeavesANodeAtTheWidestPlaceOfAPieceThatIsNarrow) {
  Courses courses(false);
  LineNetwork network = chain(courses, {5, 6, 7});
  keep_wide_lines(network, {{{0, 5}}, {{0, 6}}, {{0, 7}}}, 10);
  EXPECT_TRUE(network.lines.empty());
  ASSERT_EQ(network.nodes.size(), 1U);
  EXPECT_TRUE(network.nodes[0].alone);
  EXPECT_EQ(network.nodes[0].point, (LinePoint{17.5, 0, 1.11}));
}

}  // namespace
}  // namespace stope::topology
