#include "framework/executor/scratch_folder.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <utility>

#include "stope/error.hpp"

namespace stope {

namespace fs = std::filesystem;

ScratchFolder::ScratchFolder(fs::path path) : given_(std::move(path)) {}

ScratchFolder::~ScratchFolder() {
  std::error_code ignored;
  if (!path_.empty()) fs::remove_all(path_, ignored);
  // Folders above it that did not exist before go too, unless someone else put something there.
  if (first_made_.empty()) return;
  for (fs::path folder = path_.parent_path();; folder = folder.parent_path()) {
    if (!fs::remove(folder, ignored) || folder == first_made_) return;
  }
}

const fs::path& ScratchFolder::path() {
  const std::lock_guard lock(mutex_);
  make();
  return path_;
}

void ScratchFolder::make() {
  if (!path_.empty()) return;
  std::error_code error;
  const fs::path parent =
      fs::absolute(given_.empty() ? fs::temp_directory_path() : given_).lexically_normal();
  fs::path first_made;
  for (fs::path folder = parent; !folder.empty() && !fs::exists(folder, error);
       folder = folder.parent_path()) {
    first_made = folder;
  }
  fs::create_directories(parent, error);
  std::string name = (parent / "stope-XXXXXX").string();
  if (!mkdtemp(name.data())) {
    const std::string reason = std::strerror(errno);
    throw Error(
        fmt::format("cannot make a folder for temporary files in {}: {}; choose another "
                    "place or make room there",
                    parent.string(), reason));
  }
  first_made_ = first_made;
  path_ = name;
}

fs::path ScratchFolder::make_folder(const std::string& name) {
  const std::lock_guard lock(mutex_);
  make();
  std::string plain;
  for (const char letter : name) {
    const bool fine = (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z') ||
                      (letter >= '0' && letter <= '9') || letter == '-' || letter == '_';
    plain += fine ? letter : '_';
  }
  std::string folder = (path_ / (plain + "-XXXXXX")).string();
  if (!mkdtemp(folder.data()))
    throw Error(
        fmt::format("cannot make the temporary folder {}: {}", folder, std::strerror(errno)));
  return folder;
}

}  // namespace stope
