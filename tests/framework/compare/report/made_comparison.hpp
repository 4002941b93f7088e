#pragma once

#include <filesystem>
#include <string>

#include "framework/compare/comparison.hpp"

/// Comparisons made by hand, with the files they leave, for tests of the report.
namespace stope::made {

struct ComparisonShape {
  std::size_t arms = 2, recordings = 8, seeds = 1;
  double difference = 0.3;  ///< of each arm over the one before, in `apls`
  std::string name = "extractors";
  bool files = true;  ///< pictures and lines
};

/// Arms `watershed`, `voronoi`, `skeleton` …, on `pit-0` …, all done, judged by `apls` (better by
/// `difference` an arm), `detour` (lower is better; noise) and `coverage` (the same within delta).
/// Road graphs differ by one dead end for each arm; pictures by a bar that moves.
Comparison comparison_in(const std::filesystem::path& folder, const ComparisonShape& shape = {});

}  // namespace stope::made
