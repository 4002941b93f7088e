#include "framework/plugins/open_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <vector>

#include "framework/plugins/plugin_file.hpp"
#include "stope/digest.hpp"

namespace stope {

namespace {

[[noreturn]] void refuse_unreadable(int error) {
  throw PluginRefused(
      PluginStatus::kFailed,
      fmt::format("It cannot be read: {}. Check its permissions.", std::strerror(error)));
}

}  // namespace

OpenFile::OpenFile(const std::filesystem::path& path)
    // Not blocking: a pipe or a device in a plugin folder must not hold the program up.
    : descriptor_(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK)) {
  if (descriptor_ < 0) refuse_unreadable(errno);
  struct stat status {};
  if (::fstat(descriptor_, &status) != 0 || !S_ISREG(status.st_mode)) {
    ::close(descriptor_);
    throw PluginRefused(PluginStatus::kNotALibrary,
                        "It is not a library but a folder, a pipe or a device. Remove it from the "
                        "plugin folder.");
  }
  size_ = static_cast<std::uint64_t>(status.st_size);
  modified_ = std::int64_t{status.st_mtim.tv_sec} * 1'000'000'000 + status.st_mtim.tv_nsec;
}

OpenFile::~OpenFile() { ::close(descriptor_); }

void OpenFile::require(std::uint64_t offset, std::uint64_t count, const std::string& what) const {
  if (offset <= size_ && count <= size_ - offset) return;
  throw PluginRefused(
      PluginStatus::kTruncated,
      fmt::format("It is truncated: {} lies beyond the file's end, at byte {}. Copy "
                  "or build it again.",
                  what, size_));
}

void OpenFile::read(std::uint64_t offset, std::uint64_t count, void* data,
                    const std::string& what) const {
  require(offset, count, what);
  auto* to = static_cast<char*>(data);
  while (count > 0) {
    const ssize_t got = ::pread(descriptor_, to, count, static_cast<off_t>(offset));
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) refuse_unreadable(errno);
    if (got == 0) {
      throw PluginRefused(PluginStatus::kTruncated,
                          "It became shorter while it was read. Try again when it is built.");
    }
    to += got;
    offset += static_cast<std::uint64_t>(got);
    count -= static_cast<std::uint64_t>(got);
  }
}

std::string OpenFile::digest() const {
  Digester digester;
  std::vector<char> piece(1 << 20);
  for (std::uint64_t offset = 0; offset < size_; offset += piece.size()) {
    const std::uint64_t count = std::min<std::uint64_t>(piece.size(), size_ - offset);
    read(offset, count, piece.data(), "a part of it");
    digester.write(piece.data(), count);
  }
  return digester.digest().text();
}

}  // namespace stope
