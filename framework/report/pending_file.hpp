#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace stope::report {

/// What the names of unfinished files and folders end in; they also begin with a dot.
inline constexpr std::string_view kPendingSuffix = ".stope-part";

/// `folder/.name.stope-part` for `folder/name`: in the same folder, so that a rename is enough.
std::filesystem::path pending_name(const std::filesystem::path& final_path);
/// Whether a path is such a name.
bool is_pending(const std::filesystem::path& path);

/// The sentence for a failed system call on `path`: what could not be done, why, and what to do.
std::string io_sentence(std::string_view what, const std::filesystem::path& path, int error_number);

/// A file in the making. It is written under a temporary name beside its final one, which it takes
/// at commit(); until then whatever stands there is untouched. Dropped before that, it leaves no
/// trace. Methods throw Error with a sentence that names the file.
class PendingFile {
 public:
  explicit PendingFile(std::filesystem::path final_path);
  ~PendingFile();
  PendingFile(PendingFile&& other) noexcept;
  PendingFile& operator=(PendingFile&&) = delete;

  void write(const void* data, std::size_t size);
  void write(std::string_view text) { write(text.data(), text.size()); }
  /// Hands what was buffered to the system, so that another program can follow the file.
  void flush();
  /// Brings everything to the disk and closes. Only the rename is left after it.
  void close();
  /// Closes if need be and takes the final name, in place of a file that has it.
  void commit();

  const std::filesystem::path& final_path() const { return final_path_; }
  std::uint64_t size() const { return size_; }

 private:
  [[noreturn]] void fail(std::string_view what, int error_number) const;

  std::filesystem::path final_path_, pending_path_;
  int descriptor_ = -1;
  bool present_ = false;  ///< the temporary file exists
  std::uint64_t size_ = 0;
  std::string buffer_;
};

/// Writes a small file whole: temporary name, then rename.
void write_file(const std::filesystem::path& path, std::string_view text);

/// Makes renames in `folder` lasting. Never fails: a file system that cannot do it loses nothing
/// but speed of recovery.
void sync_folder(const std::filesystem::path& folder) noexcept;

}  // namespace stope::report
