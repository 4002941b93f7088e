// Problem: a way between two poses for a truck that cannot turn on the spot, among obstacles.
// Idea: hybrid A* (Dolgov, Thrun, Montemerlo and Diebel 2010): A* over arcs, of which one pose is
// kept for each cell of place, heading and direction; free-ground distance to the goal guides it,
// and from every pose near enough the words of Dubins or Reeds and Shepp are tried, which arrive
// exactly. Such an arrival waits in the queue by its cost like any other, so the first to come out
// is the best found.
// Cost: O(n log n) in the poses looked at, each with 5 (10 with reverse) swept outlines.
#include "plugins/planner/hybrid_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <queue>
#include <tuple>
#include <unordered_map>

#include "plugins/planner/free_ground_distance.hpp"
#include "plugins/planner/manoeuvre_costs.hpp"

namespace stope::planner {
namespace {

constexpr double kStep = 1.6;  // metres
// Of what poses that count as one span; by a step nearly every one leaves its cell.
struct Bins {
  double cell = 1;  // metres
  double headings = 72;
};
// To and fro every heading is reached everywhere: coarser bins find as much in a fifth of the
// poses.
constexpr Bins kForwards{}, kBothWays{1.5, 36};
constexpr std::size_t kMostWords = 6;  // tried from one pose
constexpr std::size_t kEveryTurn = 8;  // poses from one turn to the walls to the next
constexpr double kFromWall = 0.1;      // metres
constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

struct Reached {
  Pose2 pose;
  CurvePiece by;
  double cost = 0;
  std::uint32_t previous = kNone;
  std::uint32_t arrival = kNone;  // of Search::arrivals_
  double left = 0;                // cost to a goal, at least
  bool steered = false;           // whether that is with the turning circle
};

struct Entry {
  double estimate;
  std::uint32_t at;
  bool operator>(const Entry& other) const {
    return std::tie(estimate, at) > std::tie(other.estimate, other.at);
  }
};

class Search {
 public:
  Search(const std::vector<Pose2>& goals, const Drivability& ground, const ClearanceField& field,
         const HybridRules& rules)
      : goals_(goals),
        ground_(ground),
        field_(field),
        rules_(rules),
        bins_(rules.allow_reverse ? kBothWays : kForwards),
        costs_(ground.footprint(), rules.turning_radius, rules.allow_reverse),
        distance_(field, goals, ground.vehicle().width / 2) {}

  HybridResult run(const Pose2& start, const std::function<void()>& checkpoint) {
    HybridResult result;
    result.nearest = start;
    if (!ground_.drivable({start, {}})) return result;
    add({start, {}, 0, kNone, kNone});
    double nearest = std::numeric_limits<double>::infinity();
    while (!queue_.empty() && result.poses < rules_.most_poses) {
      checkpoint();  // a pose can cost milliseconds: its words sweep long ways
      const Entry top = queue_.top();
      queue_.pop();
      const Reached here = reached_[top.at];
      if (here.arrival != kNone) {
        result.curve = trace(start, top.at);
        return result;
      }
      if (best_[key(here.pose, here.by)] != top.at) continue;
      if (!here.steered) {
        // Words are dear, so they are spelled only for poses whose turn has come.
        Reached& weighed = reached_[top.at];
        weighed.steered = true;
        weighed.left = std::max(
            here.left, costs_.without_walls(here.pose, here.by.length < 0, goals_, here.left));
        if (weighed.left > here.left) {
          queue_.push({weighed.cost + weighed.left, top.at});
          continue;
        }
      }
      ++result.poses;
      const double left = distance_.at(here.pose.x, here.pose.y);
      if (left < nearest) nearest = left, result.nearest = here.pose;
      const bool against_wall = std::abs(here.by.length) > kStep;
      if (against_wall || worth_trying(left, result.poses)) try_arrival(top.at, left);
      expand(top.at);
      if (rules_.allow_reverse && (against_wall || result.poses % kEveryTurn == 1))
        turn_to_walls(top.at);
    }
    return result;
  }

 private:
  std::uint64_t key(const Pose2& pose, const CurvePiece& by) const {
    const auto bin = [](double value) {
      return static_cast<std::uint64_t>(static_cast<std::int64_t>(std::floor(value)) + (1 << 20));
    };
    const Vector2 at = field_.to_field(pose.x, pose.y) * (field_.cell() / bins_.cell);
    const double turn = std::remainder(pose.yaw, 2 * std::numbers::pi) / (2 * std::numbers::pi);
    const auto heading = static_cast<std::uint64_t>(
        std::clamp(std::floor((turn + 0.5) * bins_.headings), 0.0, bins_.headings - 1));
    return ((bin(at.x()) << 21 | bin(at.y())) << 8 | heading) << 1 | (by.length < 0 ? 1 : 0);
  }

  void add(Reached reached) {
    if (reached.arrival == kNone) {
      const double around = distance_.at(reached.pose.x, reached.pose.y);
      if (!std::isfinite(around)) return;
      reached.left = around;
      if (reached.previous != kNone) {
        // What its predecessor lacks, less what it cost to come here.
        const Reached& before = reached_[reached.previous];
        reached.left = std::max(around, before.left - (reached.cost - before.cost));
      }
    }
    const auto at = static_cast<std::uint32_t>(reached_.size());
    if (reached.arrival == kNone) {
      const auto [known, is_new] = best_.try_emplace(key(reached.pose, reached.by), at);
      if (!is_new) {
        if (reached_[known->second].cost <= reached.cost) return;
        known->second = at;
      }
    }
    reached_.push_back(reached);
    queue_.push({reached.cost + reached.left, at});
  }

  void expand(std::uint32_t at) {
    const Reached here = reached_[at];
    for (const double direction : {1.0, -1.0}) {
      if (direction < 0 && !rules_.allow_reverse) continue;
      for (const double share : {0.0, 0.5, -0.5, 1.0, -1.0}) {
        const double curvature = share / rules_.turning_radius;
        const CurvePiece piece{direction * kStep, curvature, curvature};
        const Pose2 end = advance(here.pose, piece);
        const double cost = here.cost + costs_.of(piece, here.by, end);
        const auto known = best_.find(key(end, piece));
        if (known != best_.end() && reached_[known->second].cost <= cost) continue;
        // Where it ends is where it mostly touches, and one look instead of many.
        if (ground_.obstruction_at(end) || !ground_.drivable({here.pose, {piece}})) continue;
        add({end, piece, cost, at, kNone});
      }
    }
  }

  /// Full lock as far as there is room, both ways and both sides: turning round between walls is
  /// made of such arcs, of which steps would find the ends late.
  void turn_to_walls(std::uint32_t at) {
    const Reached here = reached_[at];
    for (const double direction : {1.0, -1.0}) {
      for (const double share : {1.0, -1.0}) {
        const double curvature = share / rules_.turning_radius;
        CurvePiece piece{direction * std::numbers::pi * rules_.turning_radius, curvature,
                         curvature};
        const auto obstruction = ground_.first_obstruction({here.pose, {piece}});
        if (!obstruction) continue;  // no walls to turn between
        piece.length = direction * (obstruction->along - kFromWall);
        if (std::abs(piece.length) <= kStep) continue;
        const Pose2 end = advance(here.pose, piece);
        if (ground_.obstruction_at(end)) continue;  // what lies before is free, or it were that
        add({end, piece, here.cost + costs_.of(piece, here.by, end), at, kNone});
      }
    }
  }

  /// Whether words to the goals are worth trying: often near them, now and then far away.
  bool worth_trying(double left, std::size_t poses) const {
    const double radii = left / rules_.turning_radius;
    return poses == 1 || poses % (radii < 1 ? 2 : radii < 4 ? 8 : 32) == 0;
  }

  /// From one pose to all goals: the cheapest word that can be driven joins the queue.
  void try_arrival(std::uint32_t at, double left) {
    const Reached here = reached_[at];
    struct Candidate {
      double cost;
      SteeringWord word;
    };
    std::vector<Candidate> candidates;
    for (const Pose2& goal : goals_) {
      for (const SteeringWord& word : costs_.words_to(here.pose, goal)) {
        const double cost = here.cost + costs_.of(word, here.by.length < 0);
        if (word.total * rules_.turning_radius < 2 * left + 7 * rules_.turning_radius &&
            cost < best_arrival_)
          candidates.push_back({cost, word});
      }
    }
    std::stable_sort(candidates.begin(), candidates.end(),
                     [](const Candidate& a, const Candidate& b) { return a.cost < b.cost; });
    for (std::size_t i = 0; i < candidates.size() && i < kMostWords; ++i) {
      const DriveCurve curve = curve_of(candidates[i].word, here.pose, rules_.turning_radius);
      if (!ground_.drivable(curve)) continue;
      best_arrival_ = candidates[i].cost;
      const auto arrival = static_cast<std::uint32_t>(arrivals_.size());
      arrivals_.push_back(curve);
      add({curve.end(), {}, best_arrival_, at, arrival});
      return;
    }
  }

  DriveCurve trace(const Pose2& start, std::uint32_t at) const {
    DriveCurve curve{start, {}};
    std::vector<CurvePiece> pieces;
    const DriveCurve& arrival = arrivals_[reached_[at].arrival];
    for (at = reached_[at].previous; reached_[at].previous != kNone; at = reached_[at].previous)
      pieces.push_back(reached_[at].by);
    curve.pieces.assign(pieces.rbegin(), pieces.rend());
    append(curve, arrival);
    return curve;
  }

  const std::vector<Pose2>& goals_;
  const Drivability& ground_;
  const ClearanceField& field_;
  const HybridRules& rules_;
  const Bins bins_;
  const ManoeuvreCosts costs_;
  FreeGroundDistance distance_;
  std::vector<Reached> reached_;
  std::vector<DriveCurve> arrivals_;
  double best_arrival_ = std::numeric_limits<double>::infinity();
  std::unordered_map<std::uint64_t, std::uint32_t> best_;  // looked up, never walked
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue_;
};

}  // namespace

HybridResult hybrid_search(const Pose2& start, const std::vector<Pose2>& goals,
                           const Drivability& ground, const ClearanceField& field,
                           const HybridRules& rules, const std::function<void()>& checkpoint) {
  std::vector<Pose2> standing;
  for (const Pose2& goal : goals) {
    if (ground.drivable({goal, {}})) standing.push_back(goal);
  }
  if (standing.empty()) return {std::nullopt, start, 0};
  return Search(standing, ground, field, rules).run(start, checkpoint);
}

}  // namespace stope::planner
