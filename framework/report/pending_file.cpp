#include "framework/report/pending_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include "stope/error.hpp"

namespace stope::report {
namespace {

constexpr std::size_t kBufferBytes = 1 << 16;

std::string advice(int error_number) {
  switch (error_number) {
    case ENOSPC:
      return "Free some space, or choose a folder on another disk with --out.";
    case EDQUOT:
      return "Your quota is used up: free some space, or choose another folder with --out.";
    case EFBIG:
      return "The file is larger than this account or file system allows.";
    case EACCES:
    case EPERM:
    case EROFS:
      return "Choose a folder you may write to with --out.";
    case ENAMETOOLONG:
      return "Give the output a shorter name.";
    default:
      return "Choose another folder with --out if this does not go away.";
  }
}

}  // namespace

std::filesystem::path pending_name(const std::filesystem::path& final_path) {
  return final_path.parent_path() /
         fmt::format(".{}{}", final_path.filename().string(), kPendingSuffix);
}

bool is_pending(const std::filesystem::path& path) {
  const std::string name = path.filename().string();
  return name.starts_with(".") && name.ends_with(kPendingSuffix);
}

std::string io_sentence(std::string_view what, const std::filesystem::path& path,
                        int error_number) {
  return fmt::format("cannot {} {}: {}. {}", what, path.string(), std::strerror(error_number),
                     advice(error_number));
}

PendingFile::PendingFile(std::filesystem::path final_path)
    : final_path_(std::move(final_path)), pending_path_(pending_name(final_path_)) {
  descriptor_ =
      ::open(pending_path_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC | O_NOFOLLOW, 0666);
  if (descriptor_ < 0) fail("write", errno);
  present_ = true;
}

PendingFile::PendingFile(PendingFile&& other) noexcept
    : final_path_(std::move(other.final_path_)),
      pending_path_(std::move(other.pending_path_)),
      descriptor_(std::exchange(other.descriptor_, -1)),
      present_(std::exchange(other.present_, false)),
      size_(other.size_),
      buffer_(std::move(other.buffer_)) {}

PendingFile::~PendingFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
  if (present_) ::unlink(pending_path_.c_str());
}

void PendingFile::write(const void* data, std::size_t size) {
  size_ += size;
  if (buffer_.size() + size <= kBufferBytes) {
    buffer_.append(static_cast<const char*>(data), size);
    return;
  }
  flush();
  const char* next = static_cast<const char*>(data);
  while (size > 0) {
    const ssize_t written = ::write(descriptor_, next, size);
    if (written < 0) {
      if (errno == EINTR) continue;
      fail("write", errno);
    }
    next += written;
    size -= static_cast<std::size_t>(written);
  }
}

void PendingFile::flush() {
  std::size_t done = 0;
  while (done < buffer_.size()) {
    const ssize_t written = ::write(descriptor_, buffer_.data() + done, buffer_.size() - done);
    if (written < 0) {
      if (errno == EINTR) continue;
      fail("write", errno);
    }
    done += static_cast<std::size_t>(written);
  }
  buffer_.clear();
}

void PendingFile::close() {
  if (descriptor_ < 0) return;
  flush();
  // Some file systems report a full disk only here or at close().
  if (::fsync(descriptor_) != 0 && errno != EINVAL && errno != ENOTSUP) fail("write", errno);
  if (::close(std::exchange(descriptor_, -1)) != 0 && errno != EINTR) fail("write", errno);
}

void PendingFile::commit() {
  close();
  if (::rename(pending_path_.c_str(), final_path_.c_str()) != 0) fail("replace", errno);
  present_ = false;
}

void PendingFile::fail(std::string_view what, int error_number) const {
  throw Error(io_sentence(what, final_path_, error_number) +
              " What was there before is unchanged.");
}

void write_file(const std::filesystem::path& path, std::string_view text) {
  PendingFile file(path);
  file.write(text);
  file.commit();
}

void sync_folder(const std::filesystem::path& folder) noexcept {
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;
  ::fsync(descriptor);
  ::close(descriptor);
}

}  // namespace stope::report
