#include "framework/cache/object_store.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <exception>
#include <system_error>
#include <utility>

#include "stope/error.hpp"

namespace stope {
namespace {

/// Eviction goes by the time of modification: unlike that of access, every file system keeps it.
void mark_used(const std::filesystem::path& file) {
  ::utimensat(AT_FDCWD, file.c_str(), nullptr, 0);
}

void read_to_end(ByteSource& source) {
  std::array<std::byte, 1 << 16> piece{};
  while (source.remaining() > 0)
    source.read(piece.data(), std::min(piece.size(), source.remaining()));
}

}  // namespace

ObjectStore::ObjectStore(std::filesystem::path root) : root_(std::move(root)) {
  std::error_code error;
  std::filesystem::create_directories(root_ / "new", error);
  if (!error) std::filesystem::create_directories(root_ / "objects", error);
  if (error)
    throw Error(fmt::format("cannot make the store {}: {}", root_.string(), error.message()));
}

std::filesystem::path ObjectStore::file_of(const Digest& digest) const {
  const std::string name = digest.text();
  return root_ / "objects" / name.substr(0, 2) / name.substr(2);
}

bool ObjectStore::contains(const Digest& digest) const {
  std::error_code ignored;
  return std::filesystem::exists(file_of(digest), ignored);
}

StoredObject ObjectStore::put(const std::function<void(ByteSink&)>& write) {
  ObjectWriter writer(root_ / "new");
  write(writer);
  const StoredObject object = writer.finish();
  const std::filesystem::path file = file_of(object.digest);
  std::error_code error;
  std::filesystem::create_directory(file.parent_path(), error);
  if (error)
    throw Error(
        fmt::format("cannot make the folder {}: {}", file.parent_path().string(), error.message()));
  // The file that is there may be damaged: the new one takes its place whatever it holds.
  writer.commit(file);
  return object;
}

bool ObjectStore::get(const Digest& digest, const std::function<void(ByteSource&)>& read) {
  const std::filesystem::path file = file_of(digest);
  if (!contains(digest)) return false;
  bool sound = false;
  std::exception_ptr complaint;
  try {
    ObjectReader reader(file);
    try {
      read(reader);
    } catch (...) {
      complaint = std::current_exception();
    }
    // Only the whole of it tells whether a complaint is the object's fault.
    read_to_end(reader);
    sound = reader.whole(digest);
  } catch (const Error&) {
    sound = false;
  }
  if (sound && complaint) std::rethrow_exception(complaint);
  if (sound) {
    mark_used(file);
  } else {
    std::error_code ignored;
    std::filesystem::remove(file, ignored);
  }
  return sound;
}

}  // namespace stope
