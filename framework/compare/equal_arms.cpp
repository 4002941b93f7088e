#include "framework/compare/equal_arms.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace stope {
namespace {

bool equal(const Comparison& comparison, std::size_t arm, std::size_t other) {
  bool any = false;
  for (const ComparedCell& cell : comparison.cells) {
    if (cell.arm != arm) continue;
    const ComparedCell& of_other = comparison.cell(other, cell.recording, cell.seed);
    if (cell.key != of_other.key) return false;
    any = any || !cell.key.empty();
  }
  return any;
}

}  // namespace

void note_equal_arms(Comparison& comparison) {
  for (std::size_t arm = 0; arm < comparison.arms.size(); ++arm) {
    ComparedArm& late = comparison.arms[arm];
    late.same_as.clear();
    for (std::size_t other = 0; other < arm && late.same_as.empty(); ++other) {
      if (!equal(comparison, arm, other)) continue;
      late.same_as = comparison.arms[other].name;
      const std::string warning = fmt::format(
          "the arms '{}' and '{}' do the very same: nothing that makes their results differs",
          late.same_as, late.name);
      auto& warnings = comparison.warnings;
      if (std::find(warnings.begin(), warnings.end(), warning) == warnings.end())
        warnings.push_back(warning);
    }
  }
}

}  // namespace stope
