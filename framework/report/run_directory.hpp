#pragma once

#include <filesystem>
#include <map>
#include <mutex>
#include <optional>
#include <string>

#include "framework/report/folder_lock.hpp"

namespace stope::report {

/// The folder a run leaves its results in. Making one creates the folder and locks it against a
/// second run; files that are already there stay, but for what a killed run left unfinished.
/// Throws Error if it cannot be made, written to, or is in use, if it is a comparison's, if
/// outputs/ is a symbolic link, or if a folder has the name of one of the run's files.
class RunDirectory {
 public:
  explicit RunDirectory(const std::filesystem::path& folder);
  ~RunDirectory();
  RunDirectory(const RunDirectory&) = delete;

  const std::filesystem::path& folder() const { return folder_; }
  std::filesystem::path outputs() const { return folder_ / "outputs"; }
  /// For spilled payloads and temporary folders; empty at first, removed with this object.
  std::filesystem::path scratch() const { return folder_ / ".scratch.stope-part"; }
  std::filesystem::path file(const char* name) const { return folder_ / name; }

  /// Reserves `relative` (below outputs/) for the output called `owner`, makes the folders it needs
  /// and returns its full path. Throws Error if another output writes it, or if a folder on the way
  /// is a symbolic link, which would lead out.
  std::filesystem::path claim(const std::string& relative, const std::string& owner);
  /// Lets go of all that was claimed: the run begins anew.
  void forget_claims();

 private:
  std::filesystem::path folder_;
  std::optional<FolderLock> lock_;
  std::mutex mutex_;
  std::map<std::string, std::string> owners_;  ///< by relative path
};

}  // namespace stope::report
