#include "tests/benchmarks/drivable/word_lengths.hpp"

#include <fmt/core.h>
#include <ompl/base/spaces/ReedsSheppStateSpace.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "plugins/planner/reeds_shepp_words.hpp"
#include "stope/random.hpp"
#include "tests/benchmarks/drivable/trials.hpp"

namespace stope::testing {

void compare_with_ompl(int pairs) {
  constexpr double kRadius = 12;
  ompl::base::ReedsSheppStateSpace space(kRadius);
  using State = ompl::base::ReedsSheppStateSpace::StateType;
  auto* from = space.allocState()->as<State>();
  auto* to = space.allocState()->as<State>();
  Random random(1);
  std::vector<std::pair<Pose2, Pose2>> poses;
  for (int i = 0; i < pairs; ++i) {
    const auto pose = [&] {
      return Pose2{random.uniform(-60, 60), random.uniform(-60, 60), random.uniform(-M_PI, M_PI)};
    };
    const Pose2 a = pose(), b = pose();
    poses.emplace_back(a, b);
  }
  std::vector<double> ours, theirs;
  const double start = cpu_seconds();
  for (const auto& [a, b] : poses)
    ours.push_back(planner::reeds_shepp_words(a, b, kRadius).at(0).total * kRadius);
  const double middle = cpu_seconds();
  for (const auto& [a, b] : poses) {
    from->setXY(a.x, a.y), from->setYaw(a.yaw);
    to->setXY(b.x, b.y), to->setYaw(b.yaw);
    theirs.push_back(space.distance(from, to));
  }
  const double end = cpu_seconds();
  double shorter = 0, longer = 0;
  for (std::size_t i = 0; i < ours.size(); ++i) {
    shorter = std::max(shorter, theirs[i] - ours[i]);
    longer = std::max(longer, ours[i] - theirs[i]);
  }
  fmt::print(
      "Reeds-Shepp, {} random pairs: ours is at most {:.2g} m longer and {:.2g} m shorter than "
      "OMPL's; {:.2f} us for all words, OMPL {:.2f} us for the shortest\n",
      pairs, longer, shorter, (middle - start) / pairs * 1e6, (end - middle) / pairs * 1e6);
  space.freeState(from);
  space.freeState(to);
}

}  // namespace stope::testing
