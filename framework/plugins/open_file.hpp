#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace stope {

/// A file in a plugin folder, open for reading at any place.
class OpenFile {
 public:
  /// Throws PluginRefused if it cannot be read or is no regular file.
  explicit OpenFile(const std::filesystem::path& path);
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;
  ~OpenFile();

  std::uint64_t size() const { return size_; }
  std::int64_t modified() const { return modified_; }  ///< nanoseconds since 1970
  /// Reads `count` bytes at `offset` into `data`. Throws PluginRefused, naming `what`, if the file
  /// ends before.
  void read(std::uint64_t offset, std::uint64_t count, void* data, const std::string& what) const;
  /// A digest of all its bytes, hexadecimal. Throws PluginRefused if it gets shorter meanwhile.
  std::string digest() const;
  /// Throws PluginRefused, naming `what`, if the file ends before `offset + count`.
  void require(std::uint64_t offset, std::uint64_t count, const std::string& what) const;

 private:
  int descriptor_;
  std::uint64_t size_ = 0;
  std::int64_t modified_ = 0;
};

}  // namespace stope
