#include "framework/cache/object_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>
#include <zstd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "stope/error.hpp"

namespace stope {
namespace {

constexpr std::array<char, 8> kMagic{'s', 't', 'o', 'p', 'e', 'o', 'b', '1'};
constexpr int kLevel =
    1;  // grids and clouds shrink well at once; higher levels cost more than disk

/// Header: magic, then the uncompressed size, which is known only at the end.
constexpr std::size_t kHeader = kMagic.size() + sizeof(std::uint64_t);

[[noreturn]] void fail(const char* what, const std::filesystem::path& path, int error) {
  throw Error(fmt::format("{} {}: {}", what, path.string(), std::system_category().message(error)));
}

[[noreturn]] void damaged(const std::filesystem::path& path) {
  throw Error(fmt::format("the stored object {} is damaged", path.string()));
}

void write_all(int descriptor, const void* data, std::size_t size,
               const std::filesystem::path& path) {
  const char* bytes = static_cast<const char*>(data);
  while (size > 0) {
    const ssize_t done = ::write(descriptor, bytes, size);
    if (done < 0 && errno == EINTR) continue;
    if (done < 0) fail("cannot write to", path, errno);
    bytes += done;
    size -= static_cast<std::size_t>(done);
  }
}

struct FreeCompressor {
  void operator()(ZSTD_CCtx* context) const { ZSTD_freeCCtx(context); }
};
struct FreeDecompressor {
  void operator()(ZSTD_DCtx* context) const { ZSTD_freeDCtx(context); }
};

}  // namespace

struct ObjectWriter::State {
  State() = default;
  State(const State&) = delete;
  State& operator=(const State&) = delete;
  // Here and not in the writer's, which does not run if its constructor meets a full disk.
  ~State() {
    if (descriptor >= 0) ::close(descriptor);
    if (present) ::unlink(path.c_str());
  }

  std::filesystem::path path;
  int descriptor = -1;
  bool present = false;
  std::unique_ptr<ZSTD_CCtx, FreeCompressor> context{ZSTD_createCCtx()};
  std::vector<char> out = std::vector<char>(ZSTD_CStreamOutSize());
  Digester digester;
  std::uint64_t size = 0;

  void compress(const void* data, std::size_t count, ZSTD_EndDirective directive) {
    ZSTD_inBuffer in{data, count, 0};
    for (;;) {
      ZSTD_outBuffer to{out.data(), out.size(), 0};
      const std::size_t left = ZSTD_compressStream2(context.get(), &to, &in, directive);
      if (ZSTD_isError(left)) throw Error(ZSTD_getErrorName(left));
      write_all(descriptor, out.data(), to.pos, path);
      if (directive == ZSTD_e_end ? left == 0 : in.pos == in.size) return;
    }
  }
};

ObjectWriter::ObjectWriter(const std::filesystem::path& folder)
    : state_(std::make_unique<State>()) {
  std::string name = (folder / "new-XXXXXX").string();
  state_->descriptor = ::mkostemp(name.data(), O_CLOEXEC);
  if (state_->descriptor < 0) fail("cannot make a file in", folder, errno);
  state_->path = name;
  state_->present = true;
  ZSTD_CCtx_setParameter(state_->context.get(), ZSTD_c_compressionLevel, kLevel);
  ZSTD_CCtx_setParameter(state_->context.get(), ZSTD_c_checksumFlag, 1);
  const std::array<char, kHeader> empty{};
  write_all(state_->descriptor, empty.data(), empty.size(), state_->path);
}

ObjectWriter::~ObjectWriter() = default;

void ObjectWriter::write(const void* data, std::size_t size) {
  if (size == 0) return;
  state_->digester.write(data, size);
  state_->size += size;
  state_->compress(data, size, ZSTD_e_continue);
}

StoredObject ObjectWriter::finish() {
  State& state = *state_;
  state.compress(nullptr, 0, ZSTD_e_end);
  std::array<char, kHeader> header{};
  std::memcpy(header.data(), kMagic.data(), kMagic.size());
  std::memcpy(header.data() + kMagic.size(), &state.size, sizeof state.size);
  if (::pwrite(state.descriptor, header.data(), header.size(), 0) !=
      static_cast<ssize_t>(header.size()))
    fail("cannot write to", state.path, errno);
  // Not synced: what a power failure tears is found damaged and made again.
  const int closed = ::close(std::exchange(state.descriptor, -1));
  if (closed != 0) fail("cannot write to", state.path, errno);
  return {state.digester.digest(), state.size};
}

void ObjectWriter::commit(const std::filesystem::path& file) {
  if (::rename(state_->path.c_str(), file.c_str()) != 0) fail("cannot rename to", file, errno);
  state_->present = false;
}

struct ObjectReader::State {
  std::filesystem::path path;
  int descriptor = -1;
  std::unique_ptr<ZSTD_DCtx, FreeDecompressor> context{ZSTD_createDCtx()};
  std::vector<char> in = std::vector<char>(ZSTD_DStreamInSize());
  ZSTD_inBuffer have{nullptr, 0, 0};
  Digester digester;
  std::uint64_t left = 0;

  std::size_t read_file(void* data, std::size_t size) {
    for (;;) {
      const ssize_t done = ::read(descriptor, data, size);
      if (done >= 0) return static_cast<std::size_t>(done);
      if (errno != EINTR) fail("cannot read", path, errno);
    }
  }
};

ObjectReader::ObjectReader(const std::filesystem::path& file) : state_(std::make_unique<State>()) {
  State& state = *state_;
  state.path = file;
  state.descriptor = ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
  if (state.descriptor < 0) fail("cannot open", file, errno);
  std::array<char, kHeader> header{};
  if (state.read_file(header.data(), header.size()) != header.size() ||
      std::memcmp(header.data(), kMagic.data(), kMagic.size()) != 0) {
    ::close(state.descriptor);
    damaged(file);
  }
  std::memcpy(&state.left, header.data() + kMagic.size(), sizeof state.left);
}

ObjectReader::~ObjectReader() { ::close(state_->descriptor); }

void ObjectReader::read(void* data, std::size_t size) {
  State& state = *state_;
  if (size > state.left) damaged(state.path);
  if (size == 0) return;
  ZSTD_outBuffer to{data, size, 0};
  while (to.pos < to.size) {
    if (state.have.pos == state.have.size) {
      state.have = {state.in.data(), state.read_file(state.in.data(), state.in.size()), 0};
      if (state.have.size == 0) damaged(state.path);
    }
    if (ZSTD_isError(ZSTD_decompressStream(state.context.get(), &to, &state.have)))
      damaged(state.path);
  }
  state.digester.write(data, size);
  state.left -= size;
}

std::size_t ObjectReader::remaining() const { return state_->left; }

bool ObjectReader::whole(const Digest& digest) const {
  return state_->left == 0 && state_->digester.digest() == digest;
}

}  // namespace stope
