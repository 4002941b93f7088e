#include "framework/plugins/manifest_cache.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <fstream>
#include <iterator>
#include <span>
#include <system_error>

#include "stope/abi_note.hpp"
#include "stope/digest.hpp"

namespace stope {

namespace {

constexpr std::size_t kDigestBytes = 2 * sizeof(std::uint64_t);

Digest digest_of_bytes(std::span<const std::byte> bytes) {
  Digester digester;
  digester.write(bytes.data(), bytes.size());
  return digester.digest();
}

std::vector<char> read_all(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

}  // namespace

std::filesystem::path ManifestCache::file_for(const FileIdentity& identity) const {
  return *folder_ / (digest_of(identity.path).text() + ".manifest");
}

// A file holds: format, ABI epoch, identity, manifest, and the digest of all of these.

std::optional<Manifest> ManifestCache::find(const FileIdentity& identity) const {
  if (!folder_) return std::nullopt;
  const std::vector<char> content = read_all(file_for(identity));
  if (content.size() < kDigestBytes) return std::nullopt;
  const auto bytes = std::as_bytes(std::span(content));
  try {
    const auto body = bytes.first(bytes.size() - kDigestBytes);
    ByteReader tail(bytes.last(kDigestBytes));
    Digest digest;
    decode(digest.high, tail);
    decode(digest.low, tail);
    if (digest != digest_of_bytes(body)) return std::nullopt;

    ByteReader reader(body);
    std::uint32_t format = 0, epoch = 0;
    FileIdentity found;
    decode(format, reader);
    decode(epoch, reader);
    if (format != kManifestFormat || epoch != kAbiEpoch) return std::nullopt;
    decode(found, reader);
    if (found != identity) return std::nullopt;
    return decode_manifest(reader);
  } catch (const Error&) {
    return std::nullopt;
  }
}

void ManifestCache::keep(const FileIdentity& identity, const Manifest& manifest) const {
  if (!folder_) return;
  ByteBuffer body;
  encode(kManifestFormat, body);
  encode(kAbiEpoch, body);
  encode(identity, body);
  encode_manifest(manifest, body);
  const Digest digest = digest_of_bytes(body.bytes());
  encode(digest.high, body);
  encode(digest.low, body);

  std::error_code error;
  std::filesystem::create_directories(*folder_, error);
  const std::filesystem::path file = file_for(identity);
  const std::filesystem::path unfinished = fmt::format("{}.{}", file.string(), ::getpid());
  {
    std::ofstream stream(unfinished, std::ios::binary);
    stream.write(reinterpret_cast<const char*>(body.bytes().data()),
                 static_cast<std::streamsize>(body.bytes().size()));
    stream.close();
    if (!stream) {
      std::filesystem::remove(unfinished, error);
      return;
    }
  }
  std::filesystem::rename(unfinished, file, error);
  if (error) std::filesystem::remove(unfinished, error);
}

}  // namespace stope
