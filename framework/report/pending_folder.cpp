#include "framework/report/pending_folder.hpp"

#include <fcntl.h>
#include <stdio.h>

#include <algorithm>
#include <cerrno>
#include <string>
#include <utility>
#include <vector>

#include "framework/report/output_name.hpp"
#include "framework/report/pending_file.hpp"
#include "stope/error.hpp"

namespace stope::report {
namespace {

namespace fs = std::filesystem;

void move_foreign_files(const fs::path& from, const fs::path& to) {
  std::vector<fs::path> foreign;
  for (const fs::directory_entry& entry : fs::directory_iterator(from)) {
    if (!is_item_name(entry.path().filename().string())) foreign.push_back(entry.path());
  }
  for (const fs::path& path : foreign) {
    const fs::path target = to / path.filename();
    if (!fs::exists(fs::symlink_status(target))) fs::rename(path, target);
  }
}

}  // namespace

PendingFolder::PendingFolder(fs::path final_path)
    : final_path_(std::move(final_path)), pending_path_(pending_name(final_path_)) {
  std::error_code error;
  fs::create_directories(pending_path_, error);
  if (error) throw Error(io_sentence("make the folder", pending_path_, error.value()));
  present_ = true;
}

PendingFolder::~PendingFolder() {
  std::error_code ignored;
  if (present_) fs::remove_all(pending_path_, ignored);
}

void PendingFolder::commit() {
  sync_folder(pending_path_);
  if (!fs::exists(fs::symlink_status(final_path_))) {
    std::error_code error;
    fs::rename(pending_path_, final_path_, error);
    if (error) throw Error(io_sentence("make the folder", final_path_, error.value()));
    present_ = false;
    return;
  }
  // One step swaps the old folder for the new one, so that no one ever sees a mixture.
  if (::renameat2(AT_FDCWD, pending_path_.c_str(), AT_FDCWD, final_path_.c_str(),
                  RENAME_EXCHANGE) != 0)
    throw Error(io_sentence("replace the folder", final_path_, errno));
  move_foreign_files(pending_path_, final_path_);
}

}  // namespace stope::report
