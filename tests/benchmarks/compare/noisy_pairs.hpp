#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "framework/compare/statistics/verdict.hpp"
#include "stope/random.hpp"

namespace stope::testing {

/// How a measure strays from run to run.
enum class Noise : int {
  kNormal,
  kSkewed,          ///< lognormal: mostly a little, seldom much more
  kHeavy,           ///< Student's with 3 degrees of freedom
  kDiscrete,        ///< -1, 0 or 1, such as a count of dead ends
  kHeteroscedastic  ///< normal, and lognormally larger on some recordings than on others
};
inline constexpr std::array kAllNoises{Noise::kNormal, Noise::kSkewed, Noise::kHeavy,
                                       Noise::kDiscrete, Noise::kHeteroscedastic};
std::string_view name_of(Noise noise);

/// A comparison that is drawn, not run.
struct Drawn {
  Noise noise = Noise::kNormal;
  int recordings = 10;
  int measures = 1;
  int seeds = 1;          ///< runs of each arm on each recording, averaged
  double difference = 0;  ///< of the arm's first measure, in standard deviations of a paired
                          ///< difference of single runs
  double delta = 1;       ///< the smallest that matters, in the same unit
};

/// Its figures. The recordings differ from each other much more than the runs on one of them.
std::vector<MeasuredPairs> drawn_pairs(const Drawn& drawn, Random& random);

/// Paired differences that are skewed themselves, with mean 0 and deviation 1: as of arms that
/// differ in how they fail, not in how well they do on the whole.
std::vector<double> skewed_differences(int recordings, Random& random);

}  // namespace stope::testing
