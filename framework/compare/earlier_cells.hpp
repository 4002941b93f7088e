#pragma once

#include <optional>
#include <string>

#include "framework/compare/compare_job.hpp"
#include "framework/compare/comparison.hpp"

namespace stope {

/// What an earlier run of the same experiment left in the folder.
class EarlierCells {
 public:
  /// Reads comparison.json of the job's folder, if there is one. Throws Error if it cannot be read
  /// or is of another experiment: it might be somebody's only copy.
  explicit EarlierCells(const CompareJob& job);

  /// The comparison's name for itself: the earlier one's, or a new one.
  const std::string& id() const { return id_; }
  /// Takes over the cells that were done, have the same key now, and whose files are all there.
  /// Gives their number.
  std::size_t take_over(Comparison& comparison) const;
  /// What was timed; places in it are those of the earlier lists.
  const std::vector<TimedPair>& timings() const;

 private:
  /// False if what matters of a figure is said in a unit that it does not have.
  bool take_over_units(Comparison& comparison) const;

  std::optional<Comparison> earlier_;
  std::string id_;
};

}  // namespace stope
