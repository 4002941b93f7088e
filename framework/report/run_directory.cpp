#include "framework/report/run_directory.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <vector>

#include "framework/report/pending_file.hpp"
#include "stope/error.hpp"

namespace stope::report {
namespace {

namespace fs = std::filesystem;

void create_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (!error && fs::is_directory(folder, error)) return;
  const int number = error ? error.value() : ENOTDIR;
  throw Error(io_sentence("make the folder", folder, number));
}

// At the end of the run a rename would fail on them, after others have taken their names.
void refuse_folders_named_like_files(const fs::path& folder) {
  std::error_code ignored;
  for (const char* name : {"run.json", "report.html", "log.txt", "trace.json"}) {
    if (fs::is_directory(fs::symlink_status(folder / name, ignored)))
      throw Error(fmt::format(
          "{} is a folder, but the run writes a file of that name. Move it away, or choose another "
          "folder with --out.",
          (folder / name).string()));
  }
}

void refuse_comparison(const fs::path& folder) {
  std::error_code ignored;
  if (fs::exists(folder / "comparison.json", ignored))
    throw Error(fmt::format(
        "{} is the folder of a comparison, whose report.html the run would write over. Choose "
        "another folder with --out.",
        folder.string()));
}

void refuse_link(const fs::path& outputs) {
  std::error_code ignored;
  if (fs::is_symlink(outputs, ignored))
    throw Error(fmt::format(
        "{} is a symbolic link, which may lead out of the run's folder. Remove the link, or choose "
        "the folder it leads to with --out.",
        outputs.string()));
}

// A run that was killed leaves files under temporary names; their owner is gone, the lock says so.
void remove_pending(const fs::path& folder, bool deep) {
  std::error_code ignored;
  std::vector<fs::path> stale;
  for (fs::directory_iterator entry(folder, ignored), end; !ignored && entry != end;
       entry.increment(ignored)) {
    if (is_pending(entry->path())) {
      stale.push_back(entry->path());
    } else if (deep && entry->is_directory(ignored) && !entry->is_symlink(ignored)) {
      remove_pending(entry->path(), true);
    }
  }
  for (const fs::path& path : stale) fs::remove_all(path, ignored);
}

}  // namespace

RunDirectory::RunDirectory(const fs::path& folder) : folder_(fs::absolute(folder)) {
  create_folder(folder_);
  lock_.emplace(folder_);
  refuse_folders_named_like_files(folder_);
  refuse_comparison(folder_);
  refuse_link(outputs());
  create_folder(outputs());
  if (::access(folder_.c_str(), W_OK) != 0 || ::access(outputs().c_str(), W_OK) != 0)
    throw Error(io_sentence("write into", folder_, errno));
  remove_pending(folder_, false);
  remove_pending(outputs(), true);
  create_folder(scratch());
}

RunDirectory::~RunDirectory() {
  std::error_code ignored;
  fs::remove_all(scratch(), ignored);
}

void RunDirectory::forget_claims() {
  const std::lock_guard lock(mutex_);
  owners_.clear();
}

fs::path RunDirectory::claim(const std::string& relative, const std::string& owner) {
  const std::lock_guard lock(mutex_);
  const auto [place, fresh] = owners_.emplace(relative, owner);
  if (!fresh)
    throw Error(
        fmt::format("the outputs {} and {} would both write outputs/{}. Give one another name.",
                    place->second, owner, relative));
  const fs::path target = outputs() / relative;
  fs::path step = outputs();
  for (const fs::path& part : fs::path(relative).parent_path()) {
    step /= part;
    std::error_code ignored;
    if (fs::is_symlink(step, ignored))
      throw Error(fmt::format(
          "the output {} would be written through the symbolic link {}, which may lead out of the "
          "output folder. Remove the link or rename the output.",
          owner, step.string()));
    create_folder(step);
  }
  return target;
}

}  // namespace stope::report
