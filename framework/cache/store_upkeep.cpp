#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <optional>
#include <system_error>
#include <tuple>
#include <vector>

#include "framework/cache/digest_text.hpp"
#include "framework/cache/object_store.hpp"
#include "stope/error.hpp"

namespace stope {
namespace {

namespace fs = std::filesystem;

/// A file in `new/` that nobody has written to for so long belongs to a process that was killed.
constexpr auto kAbandoned = std::chrono::hours(24);
/// A journal of a map that was stopped and not gone on with for so long will not be.
constexpr auto kForgotten = std::chrono::hours(24 * 30);

/// Held by the one process that removes objects.
class StoreLock {
 public:
  explicit StoreLock(const fs::path& root)
      : descriptor_(::open((root / "lock").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666)) {
    if (descriptor_ < 0)
      throw Error(fmt::format("cannot lock the store {}: {}", root.string(),
                              std::system_category().message(errno)));
    while (::flock(descriptor_, LOCK_EX) != 0 && errno == EINTR) {
    }
  }
  ~StoreLock() { ::close(descriptor_); }
  StoreLock(const StoreLock&) = delete;
  StoreLock& operator=(const StoreLock&) = delete;

 private:
  int descriptor_;
};

struct ObjectFile {
  fs::file_time_type used;
  fs::path path;
  std::uint64_t bytes;
};

/// Files may disappear while they are listed: another process may find one damaged.
std::vector<ObjectFile> files_in(const fs::path& folder) {
  std::vector<ObjectFile> files;
  std::error_code error;
  for (fs::recursive_directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error)) {
    std::error_code gone;
    if (!entry->is_regular_file(gone) || gone) continue;
    const auto used = entry->last_write_time(gone);
    const auto bytes = gone ? 0 : entry->file_size(gone);
    if (!gone) files.push_back({used, entry->path(), bytes});
  }
  return files;
}

void remove_older(const fs::path& folder, std::chrono::hours age) {
  std::error_code ignored;
  for (const ObjectFile& file : files_in(folder))
    if (file.used + age < fs::file_time_type::clock::now()) fs::remove(file.path, ignored);
}

std::optional<Digest> digest_of_name(const fs::path& file) {
  return digest_of_hex(file.parent_path().filename().string() + file.filename().string());
}

}  // namespace

StoreUsage usage_of(const ObjectStore& store) {
  StoreUsage usage;
  for (const ObjectFile& file : files_in(store.root() / "objects")) {
    ++usage.objects;
    usage.bytes += file.bytes;
  }
  return usage;
}

StoreUsage collect_garbage(const ObjectStore& store, std::uint64_t limit) {
  const StoreLock lock(store.root());
  std::error_code ignored;
  remove_older(store.root() / "new", kAbandoned);
  remove_older(store.root() / "partial", kForgotten);
  std::vector<ObjectFile> files = files_in(store.root() / "objects");
  std::sort(files.begin(), files.end(), [](const ObjectFile& a, const ObjectFile& b) {
    return std::tie(a.used, a.path) < std::tie(b.used, b.path);
  });
  StoreUsage usage;
  for (const ObjectFile& file : files) usage.bytes += file.bytes;
  usage.objects = files.size();
  for (const ObjectFile& file : files) {
    if (usage.bytes <= limit) break;
    if (!fs::remove(file.path, ignored)) continue;
    usage.bytes -= file.bytes;
    --usage.objects;
    ++usage.removed;
  }
  return usage;
}

std::uint64_t verify(ObjectStore& store) {
  std::uint64_t damaged = 0;
  for (const ObjectFile& file : files_in(store.root() / "objects")) {
    std::error_code ignored;
    // What has no object's name is none.
    const auto digest = digest_of_name(file.path);
    if (!digest || store.file_of(*digest) != file.path) {
      fs::remove(file.path, ignored);
      ++damaged;
    } else if (!store.get(*digest, [](ByteSource&) {})) {
      ++damaged;
    }
  }
  return damaged;
}

}  // namespace stope
