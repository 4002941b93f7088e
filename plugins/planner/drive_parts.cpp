// Problem: one place where smoothing fails spoils the smoothing of a route of kilometres.
// Idea: the route is smoothed a part at a time, each from where the last one was left, with its
// wheels as they stand there; only the first half of a part is kept, so that its end does not
// matter. A place that remains obstructed is driven anew by a hybrid search, and what comes out is
// smoothed again with the metres around it; if that fails, only this place keeps its arcs.
// Cost: twice that of smoothing the whole, and a search for each place that needs one.
#include "plugins/planner/drive_parts.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "plugins/planner/drive_repair.hpp"

namespace stope::planner {
namespace {

// Metres: of a part; kept free before an obstruction to drive it anew in; worth keeping at all.
constexpr double kPart = 160, kBefore = 60, kLeast = 5;
// Metres smoothed with a place driven anew: before, behind, and of these kept.
constexpr double kLeadIn = 20, kLeadOut = 60, kKept = 5;
constexpr double kNearStart = 20;  // metres: driven anew from the start in any case
constexpr double kLook = 0.01;     // metres before a place that tell how the wheels stand there

class PartDriver {
 public:
  PartDriver(const DriveSite& site, const RouteLine& line, const DriveEnds& ends)
      : site_(site), line_(line), ends_(ends), curve_{ends.start, {}}, here_(ends.start) {}

  DrivenInParts drive() {
    const int most = 40 + static_cast<int>(line_.length() / 10);
    for (int part = 0; part < most && !done_; ++part) {
      site_.checkpoint();
      if (line_.length() - along_ < 1) break;  // at its end, yet not arrived
      if (auto stuck = drive_part()) return {curve_, stuck};
    }
    if (const auto stuck = obstruction_of(site_, curve_, ends_))
      return {curve_, DriveGuess{curve_, *stuck}};
    return {curve_, std::nullopt};
  }

 private:
  /// Smooths the next part, or drives anew what obstructs it at once. What it gives is where that
  /// fails.
  std::optional<DriveGuess> drive_part() {
    const bool last = along_ + 1.25 * kPart >= line_.length();
    const double to = last ? line_.length() : along_ + kPart;
    const DriveEnds ends = ends_until(to, last);
    const RouteLine line = line_.between(along_, to);
    auto smooth = smoothed_along(site_, line, ends);
    // In a heading of its own choice it may be that the truck cannot even stand.
    if (smooth && site_.ground.obstruction_at(smooth->start)) smooth.reset();
    const DriveCurve next = smooth ? *smooth : straight_guess(line, here_, ends.goal);
    const auto found =
        smooth ? obstruction_or_stray(site_, next, line, ends) : obstruction_of(site_, next, ends);
    if (!found) {
      keep(last ? next : part_of(next, 0, next.length() / 2));
      done_ = last;
      return std::nullopt;
    }
    if (found->along >= kBefore + kLeast) {
      keep(part_of(next, 0, found->along - kBefore));
      return std::nullopt;
    }
    std::vector<DriveGuess> guesses{{next, *found}};
    if (smooth) guesses.insert(guesses.begin(), back_to_line(next, *found, line, ends.goal));
    if (smooth && ends.free_heading && found->along < kNearStart) {
      const DriveCurve guess = straight_guess(line, here_, ends.goal);
      if (const auto place = obstruction_of(site_, guess, ends))
        guesses.insert(guesses.begin(), {guess, *place});
    }
    return drive_past(guesses, ends, last);
  }

  /// Drives one of some guesses anew where it is obstructed.
  std::optional<DriveGuess> drive_past(const std::vector<DriveGuess>& guesses,
                                       const DriveEnds& ends, bool last) {
    for (const DriveGuess& guess : guesses)
      if (drive_anew(behind(guess), ends, last, false)) return std::nullopt;
    // Reversing reaches whatever is free, so that one guess of where to go on is as good as
    // another.
    const DriveGuess& first = guesses.front();
    if (site_.request.allow_reverse && drive_anew(behind(first), ends, last, true))
      return std::nullopt;
    return behind(first);
  }

  /// A guess behind what was driven so far.
  DriveGuess behind(DriveGuess guess) const {
    guess.curve = with(guess.curve);
    guess.obstruction.along += curve_.length();
    return guess;
  }

  /// What was driven, and a part behind it.
  DriveCurve with(const DriveCurve& part) const {
    DriveCurve whole = curve_;
    if (whole.pieces.empty()) whole.start = part.start;
    append(whole, part);
    return whole;
  }

  bool drive_anew(const DriveGuess& guess, const DriveEnds& ends, bool last, bool reverse) {
    DriveCurve whole = guess.curve;
    const auto anew = repair_drive(site_, whole, guess.obstruction, ends.goal, reverse);
    if (!anew) return false;
    done_ = last && anew->to >= whole.length() - 1e-6;
    const double from = anew->from > kLeadIn + kLook ? anew->from - kLeadIn : 0;
    const double to = std::min(whole.length(), anew->to + kLeadOut);
    const DriveCurve around = part_of(whole, from, to);
    DriveEnds near{around.start, around.end(), false, std::nullopt, std::nullopt};
    if (from > 0) near.start_curvature = wheels_at(whole, from);
    if (done_) near.goal_heading = ends.goal_heading;
    const auto again = smoothed_again(site_, around, near);
    curve_ = part_of(whole, 0, again ? from : anew->to);
    if (again) {
      if (curve_.pieces.empty()) curve_.start = again->start;
      append(curve_, done_ ? *again : part_of(*again, 0, anew->to - from + kKept));
    }
    arrive(curve_.end(), anew->to - from + kLeadOut);
    return true;
  }

  void keep(const DriveCurve& part) {
    curve_ = with(part);
    arrive(part.end(), part.length());
  }

  /// Where the truck is now, and how far along the line that is.
  void arrive(const Pose2& pose, double driven) {
    here_ = pose;
    along_ =
        line_.nearest({pose.x, pose.y}, along_, std::min(line_.length(), along_ + driven + 10));
  }

  DriveEnds ends_until(double to, bool last) const {
    DriveEnds ends = ends_;
    ends.start = here_;
    if (!curve_.pieces.empty()) {
      ends.free_heading = false;
      ends.start_curvature = curve_.pieces.back().curvature_end;
    }
    if (last) return ends;
    const Vector2 end = line_.at(to);
    ends.goal = {end.x(), end.y(), line_.heading(to, 5)};
    ends.goal_heading.reset();
    return ends;
  }

  static double wheels_at(const DriveCurve& curve, double along) {
    return part_of(curve, along - kLook, along).pieces.back().curvature_end;
  }

  const DriveSite& site_;
  const RouteLine& line_;
  const DriveEnds ends_;
  DriveCurve curve_;
  Pose2 here_;
  double along_ = 0;
  bool done_ = false;
};

}  // namespace

DrivenInParts drive_in_parts(const DriveSite& site, const RouteLine& line, const DriveEnds& ends) {
  return PartDriver(site, line, ends).drive();
}

}  // namespace stope::planner
