#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "framework/cache/kept_stage.hpp"

namespace stope {

/// Which items of a map's outputs are in the store already though the map has not ended:
/// `partial/ab/cdef….port`, a line of fixed size for each item, added as it is kept. What was torn
/// at the end, when a run was killed, is left out.
class ItemJournal {
 public:
  /// Makes the folder under a store's root. Throws Error if it cannot.
  explicit ItemJournal(const std::filesystem::path& root);

  /// Notes an item. Several processes may do so at once. Best effort: what is not noted is computed
  /// again.
  void add(const Digest& key, const std::string& port, const KeptItem& item);
  /// By index; the last note counts.
  std::map<std::uint64_t, KeptItem> items(const Digest& key, const std::string& port) const;
  /// The stage has ended, so that its KeptStage tells all.
  void remove(const Digest& key, const std::string& port);

 private:
  std::filesystem::path file_of(const Digest& key, const std::string& port) const;
  std::filesystem::path folder_;
};

}  // namespace stope
