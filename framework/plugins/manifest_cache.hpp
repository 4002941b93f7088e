#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "framework/plugins/manifest.hpp"

namespace stope {

/// What tells one build of a plugin file from another.
struct FileIdentity {
  std::string path;
  std::uint64_t size = 0;
  std::int64_t modified = 0;  ///< nanoseconds since 1970
  std::string build_id;
  std::string linker_environment;  ///< that decides which libraries are found
  bool operator==(const FileIdentity&) const = default;
  static constexpr void fields(auto& s, auto&& visit) {
    visit("path", s.path);
    visit("size", s.size);
    visit("modified", s.modified);
    visit("build_id", s.build_id);
    visit("linker_environment", s.linker_environment);
  }
};

/// Manifests of plugins that were probed before, one small file each. Whatever is wrong with the
/// folder or a file in it only means that the plugin is probed again.
class ManifestCache {
 public:
  /// Without a folder it keeps nothing.
  explicit ManifestCache(std::optional<std::filesystem::path> folder)
      : folder_(std::move(folder)) {}

  /// What this very file was found to hold, or none.
  std::optional<Manifest> find(const FileIdentity& identity) const;

  /// Keeps what a file holds. Written under another name and renamed, so that a reader sees all of
  /// it or none.
  void keep(const FileIdentity& identity, const Manifest& manifest) const;

 private:
  std::filesystem::path file_for(const FileIdentity& identity) const;

  std::optional<std::filesystem::path> folder_;
};

}  // namespace stope
