#include "plugins/topology/prune_spurs.hpp"

#include <algorithm>
#include <functional>
#include <queue>

namespace stope::topology {
namespace {

/// Weight of the way travelled against the distance to the obstacle when a tip is looked for.
constexpr double kTravelWeight = 0.5;

std::size_t at(std::int32_t place) { return static_cast<std::size_t>(place); }

class SpurPruner {
 public:
  SpurPruner(LineNetwork& network, const SpurRule& rule)
      : network_(network),
        courses_(*network.courses),
        rule_(rule),
        at_nodes_(network),
        open_ends_(network.nodes.size()),
        burn_(network.nodes.size()),
        longest_(network.nodes.size(), -1),
        carries_road_(network.nodes.size(), false),
        widest_(network.nodes.size()),
        first_kept_(network.lines.size(), 0) {
    for (std::size_t i = 0; i < network.nodes.size(); ++i) {
      open_ends_[i] = at_nodes_[static_cast<std::int32_t>(i)].size();
      burn_[i] = network.nodes[i].point.distance;
      widest_[i] = network.nodes[i].point;
    }
  }

  void run() {
    burn_from_tips();
    for (const Branch& branch : branches_) first_kept_[at(branch.line)] = -1;
    for (const Branch& branch : branches_) decide(branch);
    for (const Branch& branch : branches_) complete(branch);
    for (const Branch& branch : branches_) apply(branch);
    for (const std::int32_t middle : middles_)
      if (!carries_road_[at(middle)]) network_.nodes[at(middle)] = {widest_[at(middle)], true};
    network_.tidy();
  }

 private:
  /// A line all of whose other side, seen from `root`, is a tree. Its points run from tip to root.
  struct Branch {
    std::int32_t line, tip, root;
  };

  /// A fire lit at every tip, later by the tip's distance to the obstacle, that burns along the
  /// lines at one cell a second and passes a junction when its last but one line has burnt.
  void burn_from_tips() {
    using Entry = std::pair<double, std::int32_t>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> fire;
    std::vector<bool> burnt(network_.lines.size(), false);
    for (std::size_t node = 0; node < open_ends_.size(); ++node)
      if (open_ends_[node] == 1) fire.emplace(burn_[node], static_cast<std::int32_t>(node));
    while (!fire.empty()) {
      const std::int32_t tip = fire.top().second;
      fire.pop();
      if (open_ends_[at(tip)] != 1) continue;
      const auto around = at_nodes_[tip];
      const std::int32_t name =
          *std::find_if(around.begin(), around.end(), [&](auto line) { return !burnt[at(line)]; });
      burnt[at(name)] = true;
      const std::int32_t root = point_at_root(network_.lines[at(name)], tip);
      if (open_ends_[at(root)] == 1) {
        meet_on(name, tip, root);
        continue;
      }
      burn_branch(name, tip, root);
      if (open_ends_[at(root)] == 1) fire.emplace(burn_[at(root)], root);
    }
  }

  void burn_branch(std::int32_t name, std::int32_t tip, std::int32_t root) {
    branches_.push_back({name, tip, root});
    const double burn = burn_[at(tip)] + network_.lines[at(name)].length;
    if (burn > burn_[at(root)]) {
      burn_[at(root)] = burn;
      longest_[at(root)] = name;
    }
    --open_ends_[at(tip)];
    --open_ends_[at(root)];
  }

  /// The last line of a tree burns from both ends: it is cut where the fires meet.
  void meet_on(std::int32_t name, std::int32_t tip, std::int32_t root) {
    Line line = network_.lines[at(name)];
    if (network_.points(line).size() == 2) network_.set_course(line, with_middle(line.course));
    const CourseView points = network_.points(line);
    double way = (burn_[at(root)] + line.length - burn_[at(tip)]) / 2;
    std::size_t middle = 1;
    for (; middle + 2 < points.size() && way > 0; ++middle)
      way -= distance_between(points[middle - 1], points[middle]);
    const auto node = static_cast<std::int32_t>(network_.nodes.size());
    const LinePoint point = points[middle];
    network_.nodes.push_back({point, false});
    open_ends_.push_back(2);
    burn_.push_back(point.distance);
    longest_.push_back(-1);
    carries_road_.push_back(false);
    widest_.push_back(point);
    const CourseId behind = courses_.part(line.course, middle, points.size());
    Line other{root, node, backwards(behind), courses_.length(behind)};
    network_.set_course(line, courses_.part(line.course, 0, middle + 1));
    line.to = node;
    network_.lines[at(name)] = line;
    network_.lines.push_back(other);
    first_kept_.push_back(0);
    burn_branch(name, tip, node);
    burn_branch(static_cast<std::int32_t>(network_.lines.size()) - 1, root, node);
    middles_.push_back(node);
  }

  /// A course of two points with a third between.
  CourseId with_middle(CourseId course) {
    CourseKey key(CourseKey::kMiddle);
    key.add(courses_.name(course));
    return courses_
        .make(key,
              [&] {
                const LinePoint a = courses_.view(course).front(), b = courses_.view(course).back();
                const LinePoint middle{(a.x + b.x) / 2, (a.y + b.y) / 2,
                                       (a.distance + b.distance) / 2};
                return Courses::Made{{courses_.add({a, middle, b})}, {}, 0};
              })
        .courses[0];
  }

  static std::int32_t point_at_root(Line& line, std::int32_t tip) {
    if (line.from != tip) line.reverse();
    return line.to;
  }

  void decide(const Branch& branch) {
    if (carries_road_[at(branch.tip)]) {
      first_kept_[at(branch.line)] = 0;
      carries_road_[at(branch.root)] = true;
    } else if (const std::int32_t proof = proof_of_road(branch); proof >= 0) {
      keep_up_to_face(branch.line, proof);
      carries_road_[at(branch.root)] = true;
    } else {
      widen(branch.root, widest_[at(branch.tip)]);
      widen(branch.root, courses_.widest(network_.lines[at(branch.line)].course));
    }
  }

  /// If one half of a tree is a road, the other half is its other end.
  void complete(const Branch& branch) {
    if (!std::binary_search(middles_.begin(), middles_.end(), branch.root)) return;
    if (!carries_road_[at(branch.root)] || first_kept_[at(branch.line)] >= 0) return;
    keep_up_to_face(branch.line, last_point(branch.line));
  }

  void widen(std::int32_t node, const LinePoint& point) {
    if (point.distance > widest_[at(node)].distance) widest_[at(node)] = point;
  }

  std::int32_t last_point(std::int32_t line) const {
    return static_cast<std::int32_t>(network_.points(network_.lines[at(line)]).size()) - 1;
  }

  /// The first point from the tip whose reach satisfies the rule, or -1.
  std::int32_t proof_of_road(const Branch& branch) const {
    const CourseId course = network_.lines[at(branch.line)].course;
    const double burn = burn_[at(branch.tip)];
    return courses_.number(course, burn,
                           [&] { return proof_of_road(courses_.view(course), burn); });
  }

  std::int32_t proof_of_road(const CourseView& points, double way) const {
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (i > 0) way += distance_between(points[i - 1], points[i]);
      const double own = points[i].distance;
      if (way - own >= std::max(rule_.least_reach, rule_.least_share * own))
        return static_cast<std::int32_t>(i);
    }
    return -1;
  }

  /// Along the longest branches, from a point of the first one.
  void keep_up_to_face(std::int32_t line, std::int32_t point) {
    std::vector<std::int32_t> lines;
    CourseKey key(CourseKey::kFace);
    key.add(std::int64_t{point});
    for (; line >= 0; line = longest_[at(network_.lines[at(line)].from)]) {
      lines.push_back(line);
      key.add(courses_.name(network_.lines[at(line)].course));
    }
    const Courses::Made& face = courses_.make(key, [&] { return find_face(lines, point); });
    const auto last = static_cast<std::size_t>(face.place.x);
    for (std::size_t i = 0; i < last; ++i) first_kept_[at(lines[i])] = 0;
    first_kept_[at(lines[last])] = face.number;
  }

  /// Where distance and way travelled together are largest: the point as the number, its line's
  /// place in the list as x.
  Courses::Made find_face(const std::vector<std::int32_t>& lines, std::int32_t point) const {
    double way = 0, best = -1;
    Courses::Made face;
    for (std::size_t k = 0; k < lines.size(); ++k) {
      const CourseView points = network_.points(network_.lines[at(lines[k])]);
      if (k > 0) point = last_point(lines[k]);
      for (std::int32_t i = point; i >= 0; --i) {
        if (at(i) + 1 < points.size() && i != point)
          way += distance_between(points[at(i)], points[at(i) + 1]);
        const double score = points[at(i)].distance + kTravelWeight * way;
        if (score <= best) continue;
        best = score;
        face.place.x = static_cast<double>(k);
        face.number = i;
      }
    }
    return face;
  }

  void apply(const Branch& branch) {
    Line& line = network_.lines[at(branch.line)];
    const std::int32_t first = first_kept_[at(branch.line)];
    const std::size_t count = network_.points(line).size();
    if (first < 0 || at(first) + 1 >= count) {
      // Cut right at its root: the road ends in the node there.
      network_.set_course(line, kNoCourse);
    } else if (first > 0) {
      network_.set_course(line, courses_.part(line.course, at(first), count));
      network_.nodes[at(branch.tip)].point = courses_.front(line.course);
    }
  }

  LineNetwork& network_;
  Courses& courses_;
  SpurRule rule_;
  LinesAtNodes at_nodes_;
  std::vector<std::size_t> open_ends_;
  std::vector<double> burn_;              ///< by node: when the fire came, in cells
  std::vector<std::int32_t> longest_;     ///< by node: the branch that burnt longest, or -1
  std::vector<bool> carries_road_;        ///< by node: a branch into it is kept
  std::vector<LinePoint> widest_;         ///< by node: of the branches into it
  std::vector<std::int32_t> first_kept_;  ///< by line: its first point that stays, or -1: none
  std::vector<Branch> branches_;          ///< outer before inner
  std::vector<std::int32_t> middles_;     ///< of trees, where the fires met
};

}  // namespace

void prune_spurs(LineNetwork& network, const SpurRule& rule) { SpurPruner(network, rule).run(); }

}  // namespace stope::topology
