#include "framework/cache/input_check.hpp"

namespace stope {

InputCheck::InputCheck(const Plan& plan, const std::vector<StageKey>& keys,
                       const std::vector<Fate>& fates, const FileDigests& digests)
    : digests_(digests) {
  for (std::size_t i = 0; i < plan.stages.size(); ++i) {
    std::set<std::filesystem::path>& reads = reads_.emplace_back();
    // What comes from the store was made of what its key tells, whatever the files are now.
    if (!is_made(fates[i])) continue;
    reads.insert(keys[i].files.begin(), keys[i].files.end());
    for (const auto& source : plan.stages[i].inputs)
      if (source) reads.insert(reads_[source->stage].begin(), reads_[source->stage].end());
  }
}

bool InputCheck::holds(std::size_t stage) const {
  bool same = true;
  for (const std::filesystem::path& path : reads_[stage]) same = !has_changed(path) && same;
  return same;
}

std::set<std::filesystem::path> InputCheck::changed() const {
  std::set<std::filesystem::path> all;
  for (const auto& reads : reads_) all.insert(reads.begin(), reads.end());
  for (const std::filesystem::path& path : all) has_changed(path);
  const std::lock_guard lock(mutex_);
  return changed_;
}

bool InputCheck::has_changed(const std::filesystem::path& path) const {
  {
    const std::lock_guard lock(mutex_);
    if (changed_.contains(path)) return true;
  }
  if (digests_.is_as_seen(path)) return false;
  const std::lock_guard lock(mutex_);
  changed_.insert(path);
  return true;
}

}  // namespace stope
