#pragma once

#include <chrono>
#include <filesystem>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "framework/plugins/catalogue.hpp"
#include "framework/plugins/manifest_cache.hpp"
#include "framework/plugins/plugin_file.hpp"
#include "framework/plugins/plugin_library.hpp"
#include "framework/plugins/plugin_search.hpp"

namespace stope {

/// How plugins are looked for.
struct PluginOptions {
  PluginSearch search;
  std::optional<std::filesystem::path> manifests;  ///< the cache's folder; none: no cache
  std::chrono::milliseconds probe_limit{5000};     ///< how long a new file may take to load
};

/// What the command line uses: plugin_search() around this program, manifest_folder(), 5 s.
PluginOptions default_plugin_options(const std::vector<std::filesystem::path>& command_line);

/// The stages of all plugins found. Files are judged, and new ones probed, when it is made; the
/// libraries are opened when one of their stages is.
class PluginCatalogue final : public Catalogue {
 public:
  explicit PluginCatalogue(PluginOptions options);

  const std::vector<StageRecord>& stages() const override { return stages_; }
  const StageRecord* find(std::string_view id) const override;
  std::unique_ptr<StageInstance> create(std::string_view id) const override;

  /// Every file found, in the order of search, with what became of it.
  const std::vector<PluginFile>& files() const { return files_; }
  /// Of places that were named but cannot be searched.
  const std::vector<std::string>& warnings() const { return options_.search.warnings; }
  /// Why a stage of this id is not among stages(): two files offer it. Empty if none does.
  std::string conflict(std::string_view id) const;

 private:
  void scan();
  /// Judges one file and gives what it declares.
  Manifest examine(const std::filesystem::path& path, PluginFile& file);
  void settle_conflicts();
  const PluginLibrary& library(const StageRecord& stage) const;

  PluginOptions options_;
  ManifestCache cache_;
  std::vector<PluginFile> files_;
  std::vector<StageRecord> stages_;
  std::map<std::string, FileIdentity> identities_;             ///< of files as judged, by path
  std::map<std::string, std::string, std::less<>> conflicts_;  ///< sentences, by stage id

  mutable std::mutex mutex_;
  mutable std::map<std::string, PluginLibrary> libraries_;  ///< open ones, by path
};

}  // namespace stope
