#include "framework/cache/file_digests.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <ctime>
#include <system_error>
#include <vector>

#include "framework/cache/checked_file.hpp"

namespace stope {
namespace {

namespace fs = std::filesystem;

/// A file changed so short ago may change again without its time telling.
constexpr std::int64_t kSettled = 2'000'000'000;  // ns

[[noreturn]] void unreadable(const fs::path& path, const std::string& why) {
  throw Error(fmt::format("cannot read {} to tell whether it has changed: {}", path.string(), why));
}

Digest read_and_digest(const fs::path& file, const std::atomic<bool>* stop) {
  const int descriptor = ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) unreadable(file, std::system_category().message(errno));
  Digester digester;
  std::vector<char> piece(1 << 20);
  ssize_t count = 0;
  while ((count = ::read(descriptor, piece.data(), piece.size())) != 0) {
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) {
      const int error = errno;
      ::close(descriptor);
      unreadable(file, std::system_category().message(error));
    }
    digester.write(piece.data(), static_cast<std::size_t>(count));
    if (stop && stop->load()) {
      ::close(descriptor);
      throw Cancelled();
    }
  }
  ::close(descriptor);
  return digester.digest();
}

std::int64_t nanoseconds(const timespec& time) {
  return static_cast<std::int64_t>(time.tv_sec) * 1'000'000'000 + time.tv_nsec;
}

}  // namespace

FileDigests::FileDigests(fs::path table) : table_(std::move(table)) {
  const auto saved = load_checked<Table>(table_);
  if (!saved || saved->paths.size() != saved->known.size()) return;
  for (std::size_t i = 0; i < saved->paths.size(); ++i) known_[saved->paths[i]] = saved->known[i];
}

void FileDigests::save() const {
  Table table;
  for (const auto& [path, known] : known_) {
    table.paths.push_back(path);
    table.known.push_back(known);
  }
  try {
    save_checked(table_, table);
  } catch (const Error&) {
    // The next process digests the files once more.
  }
}

Digest FileDigests::of(const fs::path& path, const std::atomic<bool>* stop) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (status.type() == fs::file_type::not_found) return digest_of(std::string("nothing"));
  if (error) unreadable(path, error.message());
  return fs::is_directory(status) ? of_folder(path, stop) : of_file(path, stop);
}

Digest FileDigests::of_file(const fs::path& file, const std::atomic<bool>* stop) {
  struct stat facts {};
  if (::stat(file.c_str(), &facts) != 0) unreadable(file, std::system_category().message(errno));
  const std::int64_t modified = nanoseconds(facts.st_mtim);
  const auto size = static_cast<std::uint64_t>(facts.st_size);
  const std::string name = fs::absolute(file).lexically_normal().string();
  if (const auto found = known_.find(name); found != known_.end()) {
    const Known& known = found->second;
    if (known.size == size && known.modified == modified && known.inode == facts.st_ino)
      return {known.high, known.low};
  }
  const Digest digest = read_and_digest(file, stop);
  timespec now{};
  ::clock_gettime(CLOCK_REALTIME, &now);
  if (nanoseconds(now) - modified > kSettled)
    known_[name] = {size, facts.st_ino, modified, digest.high, digest.low};
  return digest;
}

Digest FileDigests::of_folder(const fs::path& folder, const std::atomic<bool>* stop) {
  std::vector<std::string> names;
  std::error_code error;
  for (fs::recursive_directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error)) {
    if (entry->is_regular_file())
      names.push_back(entry->path().lexically_relative(folder).string());
  }
  if (error) unreadable(folder, error.message());
  std::sort(names.begin(), names.end());
  Digester digester;
  for (const std::string& name : names) {
    encode(name, digester);
    const Digest digest = of_file(folder / name, stop);
    digester.write(&digest, sizeof digest);
  }
  return digester.digest();
}

}  // namespace stope
