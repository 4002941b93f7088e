#pragma once

#include <filesystem>
#include <mutex>
#include <string>
#include <vector>

namespace stope {

/// The folder a run may fill: spilled payloads and the temporary folders of stages. Nothing of it
/// is left after the run; what was there before is.
class ScratchFolder {
 public:
  /// In `path`, which is made if need be; if empty, in the system's folder for temporary files.
  /// Touches nothing yet.
  explicit ScratchFolder(std::filesystem::path path);
  /// Removes everything made here.
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  /// The folder itself, made if need be. Throws Error if it cannot be made. From any thread.
  const std::filesystem::path& path();
  /// An empty folder in it for `name`. Throws Error if it cannot be made. From any thread.
  std::filesystem::path make_folder(const std::string& name);

 private:
  void make();

  std::mutex mutex_;
  std::filesystem::path given_, path_, first_made_;
};

}  // namespace stope
