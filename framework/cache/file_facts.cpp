#include "framework/cache/file_facts.hpp"

#include <fmt/format.h>
#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <ctime>
#include <optional>
#include <system_error>

#include "stope/error.hpp"

namespace stope {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void unreadable(const fs::path& path, const std::string& why) {
  throw Error(fmt::format("cannot read {} to tell whether it has changed: {}", path.string(), why));
}

std::int64_t nanoseconds(const timespec& time) {
  return static_cast<std::int64_t>(time.tv_sec) * 1'000'000'000 + time.tv_nsec;
}

FileFacts facts_of(const struct stat& status) {
  return {static_cast<std::uint64_t>(status.st_size), status.st_ino, nanoseconds(status.st_mtim),
          nanoseconds(status.st_ctim)};
}

/// Of what has this path; none if nothing has.
std::optional<struct stat> status_of(const fs::path& path) {
  struct stat status {};
  if (::stat(path.c_str(), &status) == 0) return status;
  if (errno == ENOENT || errno == ENOTDIR) return std::nullopt;
  unreadable(path, std::system_category().message(errno));
}

std::vector<PathFacts::Entry> files_below(const fs::path& folder) {
  std::vector<PathFacts::Entry> files;
  std::error_code error;
  for (fs::recursive_directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error)) {
    // A link to nowhere is no file.
    const auto status = status_of(entry->path());
    if (status && S_ISREG(status->st_mode))
      files.push_back({entry->path().lexically_relative(folder).string(), facts_of(*status)});
  }
  if (error) unreadable(folder, error.message());
  std::sort(files.begin(), files.end(),
            [](const auto& a, const auto& b) { return a.name < b.name; });
  return files;
}

}  // namespace

PathFacts facts_of(const fs::path& path) {
  const auto status = status_of(path);
  if (!status) return {};
  if (S_ISDIR(status->st_mode)) return {PathFacts::Kind::kFolder, files_below(path)};
  return {PathFacts::Kind::kFile, {{"", facts_of(*status)}}};
}

}  // namespace stope
