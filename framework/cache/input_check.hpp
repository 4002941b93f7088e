#pragma once

#include <filesystem>
#include <mutex>
#include <set>
#include <vector>

#include "framework/cache/file_digests.hpp"
#include "framework/cache/reuse.hpp"

namespace stope {

/// Looks again, while a run goes on and after it, at the files that its keys were made of. What a
/// stage gave may be kept under its key only if they are what they were: otherwise nobody knows
/// what the stage has read.
class InputCheck {
 public:
  /// All must live as long. `digests` has digested all that the keys name.
  InputCheck(const Plan& plan, const std::vector<StageKey>& keys, const std::vector<Fate>& fates,
             const FileDigests& digests);

  /// Whether all that the stage, and stages above it as far as they are made in this run, may have
  /// read until now is what its key tells. Costs one stat() for each file. Several threads may ask
  /// at once.
  bool holds(std::size_t stage) const;
  /// The files and folders of all stages that are made which have changed, by name.
  std::set<std::filesystem::path> changed() const;

 private:
  bool has_changed(const std::filesystem::path& path) const;

  const FileDigests& digests_;
  std::vector<std::set<std::filesystem::path>> reads_;  ///< by stage
  mutable std::mutex mutex_;
  /// What was once seen changed stays so: a link may be turned back.
  mutable std::set<std::filesystem::path> changed_;
};

}  // namespace stope
