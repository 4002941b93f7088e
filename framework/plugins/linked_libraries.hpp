#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace stope {

/// A library that a plugin brings into the process.
struct LinkedLibrary {
  std::string file;
  std::uint64_t size = 0;
  std::int64_t modified = 0, changed = 0;  ///< nanoseconds since 1970; its content and its inode
  std::string build;  ///< its build id, hexadecimal; of one without, a digest of its bytes
  bool operator==(const LinkedLibrary&) const = default;
  static constexpr void fields(auto& s, auto&& visit) {
    visit("file", s.file);
    visit("size", s.size);
    visit("modified", s.modified);
    visit("changed", s.changed);
    visit("build", s.build);
  }
};

/// Those that a plugin which is open in this process asks for, and those these ask for, and so on,
/// by name; but not the SDK's. What they open themselves while they run is not among them.
std::vector<LinkedLibrary> linked_libraries(const std::filesystem::path& plugin);

/// Whether their files are those they were: of the same size and times.
bool are_unchanged(const std::vector<LinkedLibrary>& libraries);

/// Names all of them and their builds, wherever their files are; empty if there are none.
std::string builds_of(const std::vector<LinkedLibrary>& libraries);

/// What the environment tells the dynamic linker: under another one other libraries may be found.
std::string linker_environment();

}  // namespace stope
