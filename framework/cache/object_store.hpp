#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>

#include "framework/cache/object_file.hpp"

namespace stope {

/// Objects by the digest of their bytes, one file each: `objects/ab/cdef…`. What is there was
/// written whole; what was damaged since is noticed when it is read, and removed. Several processes
/// may use one store at once: objects appear by renames and disappear whole.
class ObjectStore {
 public:
  /// Makes the folders that are not there. Throws Error if it cannot.
  explicit ObjectStore(std::filesystem::path root);

  const std::filesystem::path& root() const { return root_; }
  /// Keeps what `write` writes. An object that is there already is only marked as used.
  StoredObject put(const std::function<void(ByteSink&)>& write);
  /// Lets `read` read an object to its end. False if it is not there or turns out to be damaged
  /// (then it is removed, and what `read` made must be thrown away). Errors that `read` throws for
  /// an undamaged object pass through.
  bool get(const Digest& digest, const std::function<void(ByteSource&)>& read);
  bool contains(const Digest& digest) const;
  std::filesystem::path file_of(const Digest& digest) const;

 private:
  std::filesystem::path root_;
};

/// What is in a store.
struct StoreUsage {
  std::uint64_t objects = 0, bytes = 0;  ///< bytes on disk
  std::uint64_t removed = 0;             ///< objects that went when it was last tidied
};
StoreUsage usage_of(const ObjectStore& store);

/// Removes the objects that were longest not used until the store takes at most `limit` bytes.
/// Also what writers that were killed left, and journals of maps that were stopped a month ago and
/// not gone on with. One process at a time; others wait.
StoreUsage collect_garbage(const ObjectStore& store, std::uint64_t limit);

/// Reads every object, removes those that are damaged and gives their number.
std::uint64_t verify(ObjectStore& store);

}  // namespace stope
