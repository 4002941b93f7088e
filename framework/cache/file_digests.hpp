#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "stope/digest.hpp"

namespace stope {

/// Digests of what lies on the disk. A file that was digested before and has the same size, time of
/// modification and inode is not read again.
class FileDigests {
 public:
  /// Begins with what an earlier process saved in `table`; a table that is not there or damaged is
  /// an empty one.
  explicit FileDigests(std::filesystem::path table);

  /// Of a file: of its bytes. Of a folder: of the names, relative to it, and bytes of all files in
  /// and below it. Of nothing: that there is nothing. Throws Error if something cannot be read,
  /// Cancelled if `stop` is given and becomes true.
  Digest of(const std::filesystem::path& path, const std::atomic<bool>* stop = nullptr);
  /// Saves the table for the next process. Best effort: a table that cannot be saved costs time.
  void save() const;

 private:
  struct Known {
    std::uint64_t size = 0, inode = 0;
    std::int64_t modified = 0;  ///< ns
    std::uint64_t high = 0, low = 0;
    static constexpr void fields(auto& s, auto&& visit) {
      visit("size", s.size);
      visit("inode", s.inode);
      visit("modified", s.modified);
      visit("high", s.high);
      visit("low", s.low);
    }
  };
  struct Table {
    std::vector<std::string> paths;
    std::vector<Known> known;
    static constexpr void fields(auto& s, auto&& visit) {
      visit("paths", s.paths);
      visit("known", s.known);
    }
  };
  Digest of_file(const std::filesystem::path& file, const std::atomic<bool>* stop);
  Digest of_folder(const std::filesystem::path& folder, const std::atomic<bool>* stop);

  std::filesystem::path table_;
  std::map<std::string, Known> known_;
};

}  // namespace stope
