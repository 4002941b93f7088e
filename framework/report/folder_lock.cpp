#include "framework/report/folder_lock.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>

#include "framework/report/pending_file.hpp"
#include "stope/error.hpp"

namespace stope::report {

FolderLock::FolderLock(const std::filesystem::path& folder)
    : descriptor_(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
  if (descriptor_ < 0) throw Error(io_sentence("open the folder", folder, errno));
  if (::flock(descriptor_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
    ::close(descriptor_);
    throw Error(fmt::format(
        "another run is writing into {}. Wait for it, or choose another folder with --out.",
        folder.string()));
  }
}

FolderLock::~FolderLock() { ::close(descriptor_); }

}  // namespace stope::report
