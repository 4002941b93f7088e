#include "framework/executor/spill_files.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

namespace stope {

namespace {

constexpr std::uint64_t kFileSize = 256U << 20U;  ///< then the next file is begun
constexpr std::size_t kPiece = 64U << 10U;        ///< smaller writes and reads are gathered

/// Gathers small pieces; large ones go to the file without being copied.
class FileSink final : public ByteSink {
 public:
  FileSink(SpillFile& file, std::uint64_t offset) : file_(file), offset_(offset) {}
  void write(const void* data, std::size_t size) override {
    if (size < kPiece - buffer_.size()) {
      const auto* bytes = static_cast<const char*>(data);
      buffer_.append(bytes, size);
      return;
    }
    flush();
    if (size >= kPiece) {
      file_.write(data, size, offset_);
      offset_ += size;
    } else {
      buffer_.append(static_cast<const char*>(data), size);
    }
  }
  void flush() {
    file_.write(buffer_.data(), buffer_.size(), offset_);
    offset_ += buffer_.size();
    buffer_.clear();
  }

 private:
  SpillFile& file_;
  std::uint64_t offset_;
  std::string buffer_;
};

class FileSource final : public ByteSource {
 public:
  FileSource(const SpillPlace& place)
      : file_(*place.file), offset_(place.offset), left_(place.size) {}
  void read(void* data, std::size_t size) override {
    if (size == 0) return;  // an empty vector has no place to read to
    if (size > remaining()) throw Error("the encoded payload ends too early");
    auto* to = static_cast<char*>(data);
    const std::size_t buffered = std::min(size, buffer_.size() - used_);
    std::memcpy(to, buffer_.data() + used_, buffered);
    used_ += buffered;
    take(to + buffered, size - buffered);
  }
  std::size_t remaining() const override { return left_ + (buffer_.size() - used_); }

 private:
  void take(char* to, std::size_t size) {
    if (size == 0) return;
    if (size >= kPiece) {
      advance(to, size);
      return;
    }
    buffer_.resize(std::min(kPiece, left_));
    advance(buffer_.data(), buffer_.size());
    std::memcpy(to, buffer_.data(), size);
    used_ = size;
  }
  void advance(char* to, std::size_t size) {
    file_.read(to, size, offset_);
    offset_ += size;
    left_ -= size;
  }

  const SpillFile& file_;
  std::uint64_t offset_;
  std::size_t left_;
  std::vector<char> buffer_;
  std::size_t used_ = 0;
};

std::size_t encoded_size(const PayloadType& type, const void* value) {
  ByteCounter counter;
  type.encode(value, counter);
  return counter.count();
}

}  // namespace

SpillFile::SpillFile(const std::filesystem::path& folder) : folder_(folder) {
  std::string name = (folder / "payloads-XXXXXX").string();
  descriptor_ = mkostemp(name.data(), O_CLOEXEC);
  if (descriptor_ < 0)
    throw Error(
        fmt::format("no file can be made in {}: {}", folder.string(), std::strerror(errno)));
  unlink(name.c_str());
}

SpillFile::~SpillFile() { close(descriptor_); }

void SpillFile::write(const void* data, std::size_t size, std::uint64_t offset) {
  const auto* from = static_cast<const char*>(data);
  while (size > 0) {
    const ssize_t written = pwrite(descriptor_, from, size, static_cast<off_t>(offset));
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0)
      throw Error(fmt::format("writing to {} failed: {}", folder_.string(),
                              std::strerror(written < 0 ? errno : ENOSPC)));
    from += written;
    offset += static_cast<std::uint64_t>(written);
    size -= static_cast<std::size_t>(written);
  }
}

void SpillFile::read(void* data, std::size_t size, std::uint64_t offset) const {
  auto* to = static_cast<char*>(data);
  while (size > 0) {
    const ssize_t got = pread(descriptor_, to, size, static_cast<off_t>(offset));
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0)
      throw Error(fmt::format("reading a payload back from {} failed: {}", folder_.string(),
                              got < 0 ? std::strerror(errno) : "the file is shorter than it was"));
    to += got;
    offset += static_cast<std::uint64_t>(got);
    size -= static_cast<std::size_t>(got);
  }
}

SpillPlace SpillFiles::write(const PayloadType& type, const void* value) {
  SpillPlace place;
  place.size = encoded_size(type, value);
  {
    const std::lock_guard lock(mutex_);
    if (!file_ || end_ >= kFileSize) {
      file_ = std::make_shared<SpillFile>(scratch_.path());
      end_ = 0;
    }
    place.file = file_;
    place.offset = end_;
    end_ += place.size;
  }
  FileSink sink(*place.file, place.offset);
  type.encode(value, sink);
  sink.flush();
  return place;
}

std::shared_ptr<const void> read_back(const PayloadType& type, const SpillPlace& place) {
  FileSource source(place);
  return type.decode(source);
}

}  // namespace stope
