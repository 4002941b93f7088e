#pragma once

#include <filesystem>

namespace stope::report {

/// Keeps other processes out of a folder that something is written into, as long as it lives.
/// Throws Error if the folder cannot be opened or is in use.
class FolderLock {
 public:
  explicit FolderLock(const std::filesystem::path& folder);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  int descriptor_ = -1;
};

}  // namespace stope::report
