#pragma once

#include <string>
#include <vector>

#include "framework/cache/kept_stage.hpp"
#include "framework/pipeline/plan.hpp"

namespace stope {

/// What a cell is made from: its sources and the outputs of theirs that are read.
struct CellSources {
  struct Source {
    Digest key;
    std::string use;
    std::vector<PortInfo> read;
  };
  std::vector<Source> sources;
  /// Whether one of them may give other bytes each time, so that nobody knows.
  bool unknown = true;
};

/// The stages of a plan that nothing is wired to.
CellSources sources_of(const Plan& plan, const std::vector<StageKey>& keys);

/// Equal texts, equal data. Of a source that gives values alone, and whose values the store holds,
/// by what they are: a map of a file is the same whatever the run's seed is. Of all others by their
/// keys, in which the seed is. Empty if nobody knows. `kept` may be null.
std::string contents_key(const CellSources& cell, const KeptStages* kept);

}  // namespace stope
