#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "framework/compare/verdicts.hpp"

/// What must be said beside a verdict, wherever it stands: on the page, in a terminal, for
/// programs.
namespace stope {

/// On how many distinct recordings an arm or the baseline has no run at all that is done.
struct Losses {
  std::size_t recordings = 0;  ///< that there are
  std::size_t arm_failed = 0, arm_lacks = 0, baseline_failed = 0, baseline_lacks = 0;
};
Losses losses_of(const Comparison& comparison, std::size_t arm);

/// `b failed on 4, a lacks 1`; empty if every recording has both. A verdict on the rest says
/// nothing of these.
std::string losses_text(const Comparison& comparison, std::size_t arm);

/// `7 recordings cannot show any difference beside 15 tests, however clear: it takes 10.` Empty if
/// they can.
std::string too_few_text(std::size_t recordings, std::size_t tests);

/// Sentences that go with an arm's verdicts: of an arm it is a twin of, of recordings that are too
/// few to show anything, and of differences that are all equal to the last bit.
std::vector<std::string> remarks_of(const Comparison& comparison, const ArmVerdicts& verdicts);

/// Whether an experiment can show anything if all goes well, told before it runs: empty, or why
/// not. `recordings`: that the best-off arm has in common with the baseline; `arms`: with the
/// baseline.
std::string expected_remark(std::size_t recordings, std::size_t arms, std::size_t metrics);
/// The same, when it is known which arms and recordings are equal.
std::string expected_remark(const Comparison& comparison);

}  // namespace stope
