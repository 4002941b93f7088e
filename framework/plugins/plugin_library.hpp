#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

#include "framework/plugins/manifest.hpp"
#include "stope/plugin.hpp"

namespace stope {

/// A plugin's library, opened into this process for good: its code and its types stay whatever
/// happens to this object, since payloads and exceptions may outlive it.
class PluginLibrary {
 public:
  /// Told what is being done, such as `opening it`, before it is done.
  using Progress = std::function<void(const std::string& doing)>;

  /// Opens the library and reads its table. Throws PluginRefused if it cannot be opened, lacks its
  /// one symbol, or changes the floating-point modes (which are put back).
  explicit PluginLibrary(
      const std::filesystem::path& file, const Progress& progress = [](const std::string&) {});

  /// The entry of the stage, or null.
  const StageEntry* find(std::string_view stage_id) const;

  /// Asks each stage to describe itself. Throws PluginRefused if one fails to.
  Manifest describe(const Progress& progress = [](const std::string&) {}) const;

 private:
  const PluginTable* table_ = nullptr;
};

}  // namespace stope
