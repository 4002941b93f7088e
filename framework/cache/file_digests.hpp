#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "framework/cache/file_facts.hpp"
#include "stope/digest.hpp"

namespace stope {

/// The digest of a path at which there is nothing. No content has it.
inline constexpr Digest kNothingThere{};

/// Digests of what lies on the disk. A file that was digested before and of which the file system
/// tells the same is not read again.
class FileDigests {
 public:
  /// A file changed so short ago may change again without its times telling: file systems keep
  /// them to 2 s at worst.
  static constexpr std::chrono::nanoseconds kSettling = std::chrono::seconds(2);

  /// Begins with what an earlier process saved in `table`; a table that is not there or damaged is
  /// an empty one. Digests of files are remembered if they had not changed for `settling`.
  explicit FileDigests(std::filesystem::path table, std::chrono::nanoseconds settling = kSettling);

  /// Of a file: of its bytes. Of a folder: of the names, relative to it, and bytes of all files in
  /// and below it. Of nothing: kNothingThere. Throws Error if something cannot be read,
  /// Cancelled if `stop` is given and becomes true.
  Digest of(const std::filesystem::path& path, const std::atomic<bool>* stop = nullptr);
  /// Whether a path that was digested is what it was right before: nothing that it stands for has
  /// been written, replaced, touched, added or removed since. Several threads may ask at once.
  bool is_as_seen(const std::filesystem::path& path) const;
  /// Saves the table for the next process. Best effort: a table that cannot be saved costs time.
  void save() const;

 private:
  struct Known {
    std::uint64_t size = 0, inode = 0;
    std::int64_t modified = 0, changed = 0;  ///< ns
    std::uint64_t high = 0, low = 0;
    FileFacts facts() const { return {size, inode, modified, changed}; }
    static constexpr void fields(auto& s, auto&& visit) {
      visit("size", s.size);
      visit("inode", s.inode);
      visit("modified", s.modified);
      visit("changed", s.changed);
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
  Digest of_file(const std::filesystem::path& file, const FileFacts& facts,
                 const std::atomic<bool>* stop);
  Digest of_folder(const std::filesystem::path& folder, const std::vector<PathFacts::Entry>& files,
                   const std::atomic<bool>* stop);

  std::filesystem::path table_;
  std::chrono::nanoseconds settling_;
  std::map<std::string, Known> known_;
  std::map<std::string, PathFacts> seen_;  ///< by path, as it was before it was digested
};

}  // namespace stope
