#include "framework/cache/store_folder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <fstream>
#include <string_view>
#include <system_error>

#include "stope/error.hpp"

namespace stope {
namespace {

namespace fs = std::filesystem;

constexpr const char* kMark = "stope-store";
constexpr std::string_view kMarkText =
    "Results of Stope's stages, which it takes from here instead of computing them again.\n"
    "Nothing is lost but time if this folder is removed. See `stope cache`.\n";

/// What a store without a mark may hold, and the first three of which it must.
constexpr std::array<std::string_view, 6> kParts{"new",     "objects", "stages",
                                                 "partial", "digests", "lock"};
constexpr std::size_t kMust = 3;

bool is_unmarked_store(const fs::path& folder) {
  std::size_t found = 0;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    const auto part = std::find(kParts.begin(), kParts.end(), name);
    if (part == kParts.end()) return false;
    if (part < kParts.begin() + kMust) ++found;
  }
  return !error && found == kMust;
}

}  // namespace

bool is_store(const fs::path& folder) {
  std::error_code error;
  return fs::is_regular_file(folder / kMark, error) || is_unmarked_store(folder);
}

std::string why_no_store(const fs::path& folder) {
  std::error_code error;
  if (is_store(folder) || !fs::exists(folder, error)) return {};
  if (!fs::is_directory(folder, error))
    return fmt::format("{} is no folder, so that no store can be there: name another place",
                       folder.string());
  // Another process may make a store of it at this moment: the mark is the first thing in it.
  if (fs::is_empty(folder, error) || is_store(folder)) return {};
  return fmt::format(
      "{} is not empty and is no store of Stope: name an empty folder or one that does not exist",
      folder.string());
}

void make_store(const fs::path& folder) {
  if (const std::string why = why_no_store(folder); !why.empty()) throw Error(why);
  std::error_code error;
  if (fs::is_regular_file(folder / kMark, error)) return;
  fs::create_directories(folder, error);
  if (!error) {
    // The name is the mark. A disk may be too full for the text.
    std::ofstream mark(folder / kMark);
    if (!mark) error = std::error_code(errno, std::system_category());
    mark << kMarkText;
  }
  if (error)
    throw Error(fmt::format("cannot make the store {}: {}", folder.string(), error.message()));
}

}  // namespace stope
