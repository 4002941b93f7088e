#pragma once

#include <filesystem>

namespace stope::report {

/// A folder in the making, filled under a temporary name and swapped in whole at commit(). Dropped
/// before that, it leaves no trace.
class PendingFolder {
 public:
  explicit PendingFolder(std::filesystem::path final_path);
  ~PendingFolder();
  PendingFolder(const PendingFolder&) = delete;

  /// Where to write the files meanwhile.
  const std::filesystem::path& path() const { return pending_path_; }
  /// Takes the final name. Of a folder that has it, the numbered files (`000042.png`) of an earlier
  /// run go; all others, which someone else put there, move into the new one unless a file of
  /// that name came.
  void commit();

 private:
  std::filesystem::path final_path_, pending_path_;
  bool present_ = false;
};

}  // namespace stope::report
