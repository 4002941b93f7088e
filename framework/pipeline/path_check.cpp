#include "framework/pipeline/path_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <vector>

#include "framework/pipeline/sentence.hpp"

namespace stope {
namespace {

const char* kind_text(PathKind kind) {
  switch (kind) {
    case PathKind::kFile:
      return "a file";
    case PathKind::kFolder:
      return "a folder";
    default:
      return "a file or a folder";
  }
}

std::vector<std::string> names_in(const std::filesystem::path& folder) {
  // Folders of a recording can hold very many files; a misspelling is not among the last of them.
  constexpr std::size_t kMost = 10'000;
  std::vector<std::string> names;
  std::error_code problem;
  for (std::filesystem::directory_iterator i(folder, problem), end;
       !problem && i != end && names.size() < kMost; i.increment(problem))
    names.push_back(i->path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace

std::filesystem::path absolute_path(const std::string& text, const std::string& folder) {
  std::filesystem::path path = text;
  if (text.starts_with("~/"))
    if (const char* home = std::getenv("HOME")) path = std::filesystem::path(home) / text.substr(2);
  if (path.is_relative() && !folder.empty()) path = std::filesystem::path(folder) / path;
  std::error_code problem;
  path = std::filesystem::absolute(path, problem).lexically_normal();
  // A folder written with a slash at its end is the same folder.
  return path.has_filename() || !path.has_relative_path() ? path : path.parent_path();
}

PathProblem look_at_path(const std::filesystem::path& path, PathKind kind) {
  if (kind == PathKind::kNone) return {};
  std::error_code problem;
  const auto status = std::filesystem::status(path, problem);
  if (std::filesystem::exists(status)) {
    const bool folder = std::filesystem::is_directory(status);
    if (kind == PathKind::kFolder && !folder)
      return {fmt::format("must be a folder, but '{}' is a file", path.string()), ""};
    if (kind == PathKind::kFile && folder)
      return {fmt::format("must be a file, but '{}' is a folder", path.string()), ""};
    return {};
  }
  std::filesystem::path there = path.parent_path(), missing = path.filename();
  while (!there.empty() && there != there.root_path() &&
         !std::filesystem::is_directory(there, problem)) {
    missing = there.filename();
    there = there.parent_path();
  }
  return {
      fmt::format("must be {}, but '{}' does not exist", kind_text(kind), path.string()),
      did_you_mean(missing.string(), names_in(there),
                   fmt::format("'{}' exists; it has no '{}'.", there.string(), missing.string()))};
}

}  // namespace stope
