// Problem: a change of a map leaves most centre lines as they are, but all of them are joined, cut
// and bent anew on the way to the graph, and their points are most of the work.
// Idea: points are made once and never changed. Each step is a function of courses and a few
// numbers, so what it made of the same ones before is what it would make again: it costs one look
// into a table, and what comes out has the same number, so the next step finds its result as well.
// Cost: of a step that is known, its key; of all others, their points.
#include "plugins/topology/courses.hpp"

#include <algorithm>
#include <cmath>

namespace stope::topology {

double distance_between(const LinePoint& a, const LinePoint& b) {
  return std::sqrt((a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y));
}

double length_of(const std::vector<LinePoint>& points) {
  double sum = 0;
  for (std::size_t i = 1; i < points.size(); ++i) sum += distance_between(points[i - 1], points[i]);
  return sum;
}

std::vector<LinePoint> CourseView::copy(std::size_t first, std::size_t last) const {
  std::vector<LinePoint> points;
  points.reserve(last - first);
  for (std::size_t i = first; i < last; ++i) points.push_back((*this)[i]);
  return points;
}

CourseId Courses::add(std::vector<LinePoint> points) {
  const double length = length_of(points);
  return add(std::move(points), length);
}

CourseId Courses::add(std::vector<LinePoint> points, double length) {
  Course course;
  course.points = std::move(points);
  course.length = length;
  course.serial = ++serials_;
  course.ends[0] = course.points.front();
  course.ends[1] = course.points.back();
  const auto [least, most] = std::minmax_element(
      course.points.begin(), course.points.end(),
      [](const LinePoint& a, const LinePoint& b) { return a.distance < b.distance; });
  course.least_distance = least->distance;
  course.widest = *most;
  if (unused_.empty()) {
    courses_.push_back(std::move(course));
    return static_cast<CourseId>(2 * (courses_.size() - 1));
  }
  const CourseId id = unused_.back();
  unused_.pop_back();
  courses_[place(id)] = std::move(course);
  return id;
}

CourseId Courses::part(CourseId course, std::size_t first, std::size_t last) {
  if (first == 0 && last == view(course).size()) return course;
  CourseKey key(CourseKey::kPart);
  key.add(name(course)).add(static_cast<std::int64_t>(first));
  key.add(static_cast<std::int64_t>(last));
  return make(key, [&] { return Made{{add(view(course).copy(first, last))}, {}, 0}; }).courses[0];
}

CourseId Courses::joined(const std::vector<CourseId>& courses) {
  CourseKey key(CourseKey::kJoined);
  for (const CourseId course : courses) key.add(name(course));
  return make(key,
              [&] {
                std::vector<LinePoint> points{view(courses.front()).front()};
                double length_of_all = 0;
                for (const CourseId course : courses) {
                  const CourseView next = view(course);
                  for (std::size_t i = 1; i < next.size(); ++i) points.push_back(next[i]);
                  length_of_all += length(course);
                }
                return Made{{add(std::move(points), length_of_all)}, {}, 0};
              })
      .courses[0];
}

CourseId Courses::merged(const std::vector<CourseId>& courses) {
  CourseKey key(CourseKey::kMerged);
  for (const CourseId course : courses) key.add(name(course));
  return make(key,
              [&] {
                std::vector<LinePoint> points{view(courses.front()).front()};
                for (const CourseId course : courses) {
                  const CourseView next = view(course);
                  for (std::size_t i = 1; i + 1 < next.size(); ++i) points.push_back(next[i]);
                }
                points.push_back(view(courses.back()).back());
                return Made{{add(std::move(points))}, {}, 0};
              })
      .courses[0];
}

void Courses::drop(CourseId course) {
  if (used_once_) courses_[place(course)].points = {};
}

void Courses::forget_unused(const std::vector<CourseId>& lasting) {
  constexpr std::size_t kFew = 256;
  if (courses_.size() - unused_.size() < kept_ + kept_ / 2 + kFew) return;
  std::vector<bool> used(courses_.size(), false);
  for (const CourseId course : lasting) used[place(course)] = true;
  for (auto entry = memory_.begin(); entry != memory_.end();) {
    if (!entry->second.used) {
      entry = memory_.erase(entry);
      continue;
    }
    entry->second.used = false;
    for (const CourseId course : entry->second.made.courses) used[place(course)] = true;
    ++entry;
  }
  unused_.clear();
  for (std::size_t i = courses_.size(); i-- > 0;) {
    if (used[i]) continue;
    courses_[i].points = {};
    unused_.push_back(static_cast<CourseId>(2 * i));
  }
  kept_ = courses_.size() - unused_.size();
}

}  // namespace stope::topology
