#include "framework/cache/checked_file.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <system_error>

namespace stope {
namespace {

using DigestBytes = std::array<std::byte, sizeof(Digest)>;

DigestBytes bytes_of(const Digest& digest) {
  DigestBytes bytes{};
  std::memcpy(bytes.data(), &digest.high, sizeof digest.high);
  std::memcpy(bytes.data() + sizeof digest.high, &digest.low, sizeof digest.low);
  return bytes;
}

DigestBytes digest_bytes(std::span<const std::byte> bytes) {
  Digester digester;
  digester.write(bytes.data(), bytes.size());
  return bytes_of(digester.digest());
}

}  // namespace

std::optional<std::vector<std::byte>> read_checked(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  const auto all = std::as_bytes(std::span(text.data(), text.size()));
  if (all.size() < sizeof(DigestBytes)) return std::nullopt;
  const auto bytes = all.first(all.size() - sizeof(DigestBytes));
  const DigestBytes digest = digest_bytes(bytes);
  if (!std::equal(digest.begin(), digest.end(), all.end() - sizeof(DigestBytes)))
    return std::nullopt;
  return std::vector<std::byte>(bytes.begin(), bytes.end());
}

void write_checked(const std::filesystem::path& file, std::span<const std::byte> bytes) {
  const std::filesystem::path pending = file.string() + fmt::format(".{}", ::getpid());
  const DigestBytes digest = digest_bytes(bytes);
  std::error_code error;
  {
    std::ofstream stream(pending, std::ios::binary | std::ios::trunc);
    stream.write(reinterpret_cast<const char*>(bytes.data()),
                 static_cast<std::streamsize>(bytes.size()));
    stream.write(reinterpret_cast<const char*>(digest.data()), sizeof digest);
    if (!stream.flush()) error = std::error_code(errno, std::system_category());
  }
  if (!error) std::filesystem::rename(pending, file, error);
  if (!error) return;
  std::error_code ignored;
  std::filesystem::remove(pending, ignored);
  throw Error(fmt::format("cannot write {}: {}", file.string(), error.message()));
}

}  // namespace stope
