#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "plugins/topology/courses.hpp"
#include "plugins/topology/padded_grid.hpp"

namespace stope::topology {

/// A centre line between two nodes, or around from one node to itself.
struct Line {
  std::int32_t from = 0, to = 0;  ///< places in LineNetwork::nodes
  CourseId course = kNoCourse;    ///< its ends are the nodes' places; none: no longer there
  double length = 0;              ///< of its course
  bool erased() const { return course == kNoCourse; }
  void reverse() {
    std::swap(from, to);
    course = backwards(course);
  }
};

/// Centre lines while they are worked on. The steps that work on them break ties by the order of
/// nodes and lines: it must follow from geometry alone.
struct LineNetwork {
  struct Node {
    LinePoint point;
    bool alone = false;  ///< stands for a piece of free space without lines
  };
  explicit LineNetwork(Courses& all_courses) : courses(&all_courses) {}

  Courses* courses;
  std::vector<Node> nodes;
  std::vector<Line> lines;

  CourseView points(const Line& line) const { return courses->view(line.course); }
  /// Gives a line another course.
  void set_course(Line& line, CourseId course) {
    if (course != line.course && line.course != kNoCourse) courses->drop(line.course);
    line.course = course;
    line.length = course == kNoCourse ? 0 : courses->length(course);
  }
  /// Joins lines that meet two and two, and removes erased lines and nodes nothing ends at, unless
  /// they are alone. A ring without a junction keeps one node. Joined lines keep the places of the
  /// nodes between them, or not.
  void tidy(bool keep_places = true);
};

/// The lines that end at each node; one from a node to itself is there twice.
class LinesAtNodes {
 public:
  explicit LinesAtNodes(const LineNetwork& network);
  std::span<const std::int32_t> operator[](std::int32_t node) const {
    const auto place = static_cast<std::size_t>(node);
    return std::span(lines_).subspan(begin_[place], begin_[place + 1] - begin_[place]);
  }

 private:
  std::vector<std::size_t> begin_;
  std::vector<std::int32_t> lines_;
};

}  // namespace stope::topology
