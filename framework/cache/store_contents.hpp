#pragma once

#include <cstdint>
#include <ctime>
#include <string>
#include <vector>

#include "framework/cache/object_store.hpp"

namespace stope {

/// What a store holds of one key, for people.
struct StoredRecord {
  Digest key;
  std::string name;                ///< of the stage
  std::vector<std::string> ports;  ///< of which something is there
  std::uint64_t items = 0, missing = 0;
  std::uint64_t bytes = 0;  ///< on the disk; an object that several hold counts for each
  std::time_t used = 0;     ///< when it, or an item of it, was last written or read
};

/// What is in a store, the last used first.
std::vector<StoredRecord> contents_of(const ObjectStore& store);

/// Reads what the store knows of keys, and the table of digests of input files; removes what is
/// damaged or does not belong there, and gives the number of such files.
std::uint64_t verify_records(const ObjectStore& store);

/// Forgets keys of which an object is gone, and gives their number.
std::uint64_t forget_what_is_gone(const ObjectStore& store);

}  // namespace stope
