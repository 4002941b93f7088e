#pragma once

namespace stope::benchmark {

/// Prints what K arms that differ late cost together, cold, beside the common part and the sum of
/// their own parts, each measured by itself. False if any is more than 5 % above.
bool compare_shared_prefixes(int repetitions);

}  // namespace stope::benchmark
