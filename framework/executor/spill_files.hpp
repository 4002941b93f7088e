#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>

#include "framework/executor/scratch_folder.hpp"
#include "stope/payload.hpp"

namespace stope {

/// A file without a name: the kernel removes it when nobody holds it open, even after a crash.
class SpillFile {
 public:
  /// Throws Error if it cannot be made.
  explicit SpillFile(const std::filesystem::path& folder);
  ~SpillFile();
  SpillFile(const SpillFile&) = delete;
  SpillFile& operator=(const SpillFile&) = delete;

  void write(const void* data, std::size_t size, std::uint64_t offset);
  void read(void* data, std::size_t size, std::uint64_t offset) const;

 private:
  std::filesystem::path folder_;
  int descriptor_;
};

/// Where a payload was spilled to. The place is freed with the file once nothing in it is needed.
struct SpillPlace {
  std::shared_ptr<SpillFile> file;
  std::uint64_t offset = 0;
  std::size_t size = 0;
};

/// Writes payloads one after the other into a few large files of the scratch folder. Any thread may
/// use it; several write at once.
class SpillFiles {
 public:
  explicit SpillFiles(ScratchFolder& scratch) : scratch_(scratch) {}
  /// Throws Error with a sentence that names the place, such as of a full disk.
  SpillPlace write(const PayloadType& type, const void* value);

 private:
  ScratchFolder& scratch_;
  std::mutex mutex_;
  std::shared_ptr<SpillFile> file_;
  std::uint64_t end_ = 0;
};

/// Brings a payload back. Throws Error.
std::shared_ptr<const void> read_back(const PayloadType& type, const SpillPlace& place);

}  // namespace stope
