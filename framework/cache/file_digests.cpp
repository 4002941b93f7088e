#include "framework/cache/file_digests.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <system_error>
#include <vector>

#include "framework/cache/checked_file.hpp"

namespace stope {
namespace {

namespace fs = std::filesystem;

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

std::string name_of(const fs::path& path) { return fs::absolute(path).lexically_normal().string(); }

/// Since 1970.
std::chrono::nanoseconds now() { return std::chrono::system_clock::now().time_since_epoch(); }

}  // namespace

FileDigests::FileDigests(fs::path table, std::chrono::nanoseconds settling)
    : table_(std::move(table)), settling_(settling) {
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
  // Looked at before it is read: who changes it while it is read is seen later.
  PathFacts facts = facts_of(path);
  Digest digest;
  switch (facts.kind) {
    case PathFacts::Kind::kNothing:
      digest = kNothingThere;
      break;
    case PathFacts::Kind::kFile:
      digest = of_file(path, facts.files[0].facts, stop);
      break;
    case PathFacts::Kind::kFolder:
      digest = of_folder(path, facts.files, stop);
      break;
  }
  // Of two digests of a path in one run the first counts.
  seen_.emplace(name_of(path), std::move(facts));
  return digest;
}

bool FileDigests::is_as_seen(const fs::path& path) const {
  const auto seen = seen_.find(name_of(path));
  if (seen == seen_.end()) return false;
  try {
    return facts_of(path) == seen->second;
  } catch (const Error&) {
    return false;
  }
}

Digest FileDigests::of_file(const fs::path& file, const FileFacts& facts,
                            const std::atomic<bool>* stop) {
  const std::string name = name_of(file);
  if (const auto found = known_.find(name); found != known_.end() && found->second.facts() == facts)
    return {found->second.high, found->second.low};
  const std::int64_t settled = (now() - settling_).count();
  const Digest digest = read_and_digest(file, stop);
  if (std::max(facts.modified, facts.changed) < settled) {
    known_[name] = {facts.size,    facts.inode, facts.modified,
                    facts.changed, digest.high, digest.low};
  } else {
    known_.erase(name);
  }
  return digest;
}

Digest FileDigests::of_folder(const fs::path& folder, const std::vector<PathFacts::Entry>& files,
                              const std::atomic<bool>* stop) {
  Digester digester;
  for (const auto& [name, facts] : files) {
    encode(name, digester);
    const Digest digest = of_file(folder / name, facts, stop);
    digester.write(&digest, sizeof digest);
  }
  return digester.digest();
}

}  // namespace stope
