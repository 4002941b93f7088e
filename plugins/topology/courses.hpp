#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <unordered_map>
#include <vector>

namespace stope::topology {

/// A point of a centre line, in cells from the lower left corner of the grid (a cell's centre is
/// half a cell further), with its distance to the centre of the nearest obstacle cell.
struct LinePoint {
  double x = 0, y = 0;
  double distance = 0;
  bool operator==(const LinePoint&) const = default;
};

double distance_between(const LinePoint& a, const LinePoint& b);
double length_of(const std::vector<LinePoint>& points);

/// A course of Courses, in one of its two directions.
using CourseId = std::int32_t;
constexpr CourseId kNoCourse = -1;
inline CourseId backwards(CourseId course) { return course ^ 1; }

/// A course's points in its direction.
class CourseView {
 public:
  CourseView(const std::vector<LinePoint>& points, bool backwards)
      : first_(backwards ? &points.back() : points.data()),
        step_(backwards ? -1 : 1),
        count_(points.size()) {}
  std::size_t size() const { return count_; }
  const LinePoint& operator[](std::size_t i) const {
    return first_[step_ * static_cast<std::ptrdiff_t>(i)];
  }
  const LinePoint& front() const { return (*this)[0]; }
  const LinePoint& back() const { return (*this)[count_ - 1]; }
  /// Points from place `first` to before `last`.
  std::vector<LinePoint> copy(std::size_t first, std::size_t last) const;
  std::vector<LinePoint> copy() const { return copy(0, count_); }

 private:
  const LinePoint* first_;
  std::ptrdiff_t step_;
  std::size_t count_;
};

/// What is made of courses, and of what: a step's name, the courses and the numbers it depends on.
class CourseKey {
 public:
  enum Step : std::uint64_t {
    kPart,
    kJoined,
    kMerged,
    kWideParts,
    kMiddle,
    kFace,
    kMoved,
    kStraightened
  };
  explicit CourseKey(Step step) { add_word(step); }
  CourseKey& add(std::int64_t number) { return add_word(static_cast<std::uint64_t>(number)); }
  CourseKey& add(double number) { return add_word(std::bit_cast<std::uint64_t>(number)); }
  CourseKey& add(const LinePoint& point) { return add(point.x).add(point.y).add(point.distance); }
  bool operator==(const CourseKey& other) const {
    return count_ == other.count_ && hash_ == other.hash_ && more_ == other.more_ &&
           std::equal(few_.begin(), few_.begin() + std::min(count_, few_.size()),
                      other.few_.begin());
  }
  struct Hash {
    std::size_t operator()(const CourseKey& key) const { return key.hash_; }
  };

 private:
  CourseKey& add_word(std::uint64_t word) {
    hash_ = (hash_ ^ word) * 0x9E3779B97F4A7C15ULL;
    hash_ ^= hash_ >> 29;
    // Most keys are short enough to need no memory of their own.
    if (count_ < few_.size())
      few_[count_] = word;
    else
      more_.push_back(word);
    ++count_;
    return *this;
  }
  std::array<std::uint64_t, 8> few_{};
  std::vector<std::uint64_t> more_;
  std::size_t count_ = 0;
  std::uint64_t hash_ = 0;
};

/// The points of centre lines. They never change, so that lines share them, and what has been made
/// of some before is found instead of made again.
class Courses {
 public:
  struct Made {
    std::vector<CourseId> courses;
    LinePoint place;
    std::int32_t number = 0;
  };

  /// `used_once`: nothing is asked for twice, so points may go as soon as others are made of them.
  explicit Courses(bool used_once) : used_once_(used_once) {}
  Courses(const Courses&) = delete;
  Courses& operator=(const Courses&) = delete;

  CourseId add(std::vector<LinePoint> points);
  CourseId add(std::vector<LinePoint> points, double length);

  CourseView view(CourseId course) const { return {of(course).points, (course & 1) != 0}; }
  const LinePoint& front(CourseId course) const { return of(course).ends[course & 1]; }
  const LinePoint& back(CourseId course) const { return of(course).ends[~course & 1]; }
  double length(CourseId course) const { return of(course).length; }
  double least_distance(CourseId course) const { return of(course).least_distance; }
  /// Of several places with the largest distance a fixed one.
  const LinePoint& widest(CourseId course) const { return of(course).widest; }
  /// Of a course in its direction, for keys: unlike its place no other ever has it.
  std::int64_t name(CourseId course) const { return 2 * of(course).serial + (course & 1); }

  /// The points from place `first` to before `last`, at least two.
  CourseId part(CourseId course, std::size_t first, std::size_t last);
  /// One behind the other; each begins where the one before it ends.
  CourseId joined(const std::vector<CourseId>& courses);
  /// The same without the places where they meet: nothing branches off there any more.
  CourseId merged(const std::vector<CourseId>& courses);
  /// What `make` gives, which must depend on the key alone.
  template <class Make>
  const Made& make(const CourseKey& key, Make make) {
    if (const auto known = memory_.find(key); known != memory_.end()) {
      known->second.used = true;
      return known->second.made;
    }
    Made made = make();
    return memory_.emplace(key, Entry{std::move(made), true}).first->second.made;
  }
  /// A number that `count` gives, which must depend on the course in its direction and on
  /// `argument` alone. Only the last argument's is remembered.
  template <class Count>
  std::int32_t number(CourseId course, double argument, Count count) {
    Note& note = courses_[place(course)].notes[course & 1];
    if (note.argument != argument) note = {argument, count()};
    return note.number;
  }

  /// Nobody will ask for it any more, if each is used but once.
  void drop(CourseId course);
  /// Forgets now and then what nobody has asked for since the last time, and all
  /// courses but the `lasting` ones that were made of nothing.
  void forget_unused(const std::vector<CourseId>& lasting);

 private:
  struct Note {
    double argument = std::numeric_limits<double>::quiet_NaN();
    std::int32_t number = 0;
  };
  struct Course {
    std::vector<LinePoint> points;
    double length = 0, least_distance = 0;
    std::int64_t serial = 0;
    LinePoint ends[2], widest;
    Note notes[2];  ///< by direction
  };
  struct Entry {
    Made made;
    bool used = true;
  };
  static std::size_t place(CourseId course) { return static_cast<std::size_t>(course / 2); }
  const Course& of(CourseId course) const { return courses_[place(course)]; }

  bool used_once_;
  std::vector<Course> courses_;
  std::vector<CourseId> unused_;
  std::int64_t serials_ = 0;
  std::size_t kept_ = 0;  ///< how many courses there were when unused ones were last forgotten
  std::unordered_map<CourseKey, Entry, CourseKey::Hash> memory_;
};

}  // namespace stope::topology
