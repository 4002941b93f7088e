#pragma once

#include <functional>
#include <vector>

#include "framework/compare/compare_job.hpp"
#include "framework/compare/comparison.hpp"

namespace stope {

/// Times each arm against the baseline, on every recording and seed that both have done, as often
/// as the experiment asks: the stages that only one of the two has, in turns and in pairs, each
/// pair in the other order than the one before, after one run of each that does not count. What the
/// arms have in common comes from the store; exports and stages that give nothing but measures are
/// not part of what is compared. What `earlier` holds of the same work, in as many pairs, is kept
/// as it is unless the job asks for it anew. `taken` is called after each that was timed now. False
/// if it was cancelled.
bool time_arms(const CompareJob& job, const std::vector<TimedPair>& earlier, Comparison& comparison,
               const std::function<void()>& taken);

/// What pairs of times come to.
struct TimingSummary {
  struct Of {
    double least = 0, median = 0, most = 0;
  };
  Of baseline, arm;  ///< seconds
  Of ratio;          ///< arm / baseline, pair by pair
};
TimingSummary summary_of(const TimedPair& timed);

/// What the medians of an arm's timings come to, over all recordings and seeds that were timed; of
/// only one, its pairs.
TimingSummary summary_of(const Comparison& comparison, std::size_t arm);

}  // namespace stope
