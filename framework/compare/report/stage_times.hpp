#pragma once

#include <optional>
#include <string>
#include <vector>

#include "framework/compare/comparison.hpp"

namespace stope::report {

/// Least, middle and greatest of some times, in seconds.
struct Spread {
  double least = 0, median = 0, greatest = 0;
  std::size_t count = 0;
};

/// Of no values: a count of 0.
Spread spread_of(std::vector<double> values);

/// What a stage took in one arm, over its recordings and seeds.
struct StageTime {
  std::string use;
  Spread seconds;
  std::size_t ran = 0, shared = 0, stored = 0;  ///< cells by what became of it
};

/// A stage in all arms that have it.
struct StageRow {
  std::string name;
  std::vector<std::optional<StageTime>> arms;
};

/// In the order of the arms' plans; what is only in a later arm comes after what it follows there.
std::vector<StageRow> stage_times(const Comparison& comparison);

/// Time a stage for each arm, and timings taken in turns where the experiment asked for them.
std::string stage_times_html(const Comparison& comparison);

}  // namespace stope::report
