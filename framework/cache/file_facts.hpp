#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace stope {

/// What the file system tells of a file. Whoever writes to it, replaces it or touches it changes
/// at least one of these.
struct FileFacts {
  std::uint64_t size = 0;  ///< bytes
  std::uint64_t inode = 0;
  std::int64_t modified = 0;  ///< ns since 1970; programs such as tar set it as they like
  std::int64_t changed = 0;   ///< ns since 1970; set by the system alone, at each change
  bool operator==(const FileFacts&) const = default;
};

/// What stands at a path at one moment.
struct PathFacts {
  enum class Kind : int { kNothing, kFile, kFolder };
  struct Entry {
    std::string name;  ///< relative to the folder; empty for the file itself
    FileFacts facts;
    bool operator==(const Entry&) const = default;
  };
  Kind kind = Kind::kNothing;
  std::vector<Entry> files;  ///< the one, or those in and below a folder, by name
  bool operator==(const PathFacts&) const = default;
};

/// Looks at a path. Throws Error if it cannot be looked at. One call of stat() for each file.
PathFacts facts_of(const std::filesystem::path& path);

}  // namespace stope
