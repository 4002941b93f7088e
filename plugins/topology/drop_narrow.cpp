#include "plugins/topology/drop_narrow.hpp"

namespace stope::topology {
namespace {

/// The parts of a course that are wide enough. `number` says whether the first has the course's
/// begin (1) and the last its end (2).
Courses::Made wide_parts(Courses& courses, CourseId course, double least) {
  const CourseView points = courses.view(course);
  const auto narrow = [&](std::size_t i) { return points[i].distance < least; };
  std::vector<std::pair<std::size_t, std::size_t>> runs;
  Courses::Made made;
  for (std::size_t begin = 0; begin < points.size();) {
    while (begin < points.size() && narrow(begin)) ++begin;
    std::size_t end = begin;
    while (end < points.size() && !narrow(end)) ++end;
    if (end - begin >= 2) {
      if (begin == 0) made.number |= 1;
      if (end == points.size()) made.number |= 2;
      runs.emplace_back(begin, end);
    }
    begin = end;
  }
  for (const auto& [begin, end] : runs) made.courses.push_back(courses.part(course, begin, end));
  return made;
}

}  // namespace

void drop_narrow(LineNetwork& network, double least_distance) {
  Courses& courses = *network.courses;
  for (auto& node : network.nodes) node.alone = node.alone && node.point.distance >= least_distance;
  const std::size_t count = network.lines.size();
  for (std::size_t i = 0; i < count; ++i) {
    const Line line = network.lines[i];
    if (courses.least_distance(line.course) >= least_distance) continue;
    CourseKey key(CourseKey::kWideParts);
    key.add(courses.name(line.course)).add(least_distance);
    const Courses::Made& parts =
        courses.make(key, [&] { return wide_parts(courses, line.course, least_distance); });
    network.set_course(network.lines[i], kNoCourse);
    for (std::size_t k = 0; k < parts.courses.size(); ++k) {
      const CourseId course = parts.courses[k];
      const auto new_end = [&](const LinePoint& point) {
        network.nodes.push_back({point, false});
        return static_cast<std::int32_t>(network.nodes.size() - 1);
      };
      Line part{line.from, line.to, course, courses.length(course)};
      if (k > 0 || !(parts.number & 1)) part.from = new_end(courses.front(course));
      if (k + 1 < parts.courses.size() || !(parts.number & 2))
        part.to = new_end(courses.back(course));
      network.lines.push_back(part);
    }
  }
  network.tidy();
}

}  // namespace stope::topology
