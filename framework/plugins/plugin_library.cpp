#include "framework/plugins/plugin_library.hpp"

#include <dlfcn.h>
#include <fmt/format.h>

#include <boost/dll/shared_library.hpp>
#include <system_error>

#include "framework/plugins/floating_point_modes.hpp"
#include "framework/plugins/plugin_file.hpp"

namespace stope {

namespace {

namespace load_mode = boost::dll::load_mode;

/// More stages than any plugin has: a table that claims them is no table.
constexpr std::size_t kMostStages = 10'000;

std::string last_error() {
  const char* text = ::dlerror();
  return text ? text : "the system gives no reason";
}

boost::dll::shared_library open_library(const std::filesystem::path& file) {
  // Never unloaded: Boost.DLL has no name for this mode but hands it on.
  const auto keep = static_cast<load_mode::type>(RTLD_NODELETE);
  std::error_code error;
  boost::dll::shared_library library;
  library.load(file, load_mode::rtld_now | load_mode::rtld_local | keep, error);
  if (error) {
    throw PluginRefused(PluginStatus::kFailed,
                        fmt::format("It cannot be opened: {}. Install the library it needs, or "
                                    "rebuild it against the SDK of this Stope.",
                                    last_error()));
  }
  return library;
}

const PluginTable* read_table(const boost::dll::shared_library& library) {
  if (!library.has(kPluginSymbol)) {
    throw PluginRefused(PluginStatus::kFailed,
                        fmt::format("It does not export the symbol {}: build it with "
                                    "stope_add_plugin().",
                                    kPluginSymbol));
  }
  const PluginTable* table = library.get<const PluginTable*()>(kPluginSymbol)();
  if (table == nullptr || table->epoch != kAbiEpoch || table->id == nullptr ||
      table->version == nullptr || table->stages == nullptr || table->stage_count > kMostStages) {
    throw PluginRefused(PluginStatus::kFailed,
                        "Its table of stages does not make sense: rebuild it with "
                        "stope_add_plugin().");
  }
  for (std::size_t i = 0; i < table->stage_count; ++i) {
    const StageEntry* entry = table->stages[i];
    if (!entry || !entry->id || !entry->describe || !entry->create) {
      throw PluginRefused(PluginStatus::kFailed,
                          fmt::format("Entry {} of its table of stages is empty: rebuild it with "
                                      "stope_add_plugin().",
                                      i));
    }
  }
  return table;
}

}  // namespace

PluginLibrary::PluginLibrary(const std::filesystem::path& file, const Progress& progress) {
  const FloatingPointModes before = floating_point_modes();
  progress("being opened");
  const boost::dll::shared_library library = open_library(file);
  if (floating_point_modes() != before) {
    set_floating_point_modes(before);
    throw PluginRefused(
        PluginStatus::kFloatingPoint,
        "It changes the floating-point modes when it is opened, so that other stages "
        "would compute other numbers: rebuild it, and the libraries it brings, "
        "without -ffast-math and -Ofast.");
  }
  progress("giving its table of stages");
  table_ = read_table(library);
}

const StageEntry* PluginLibrary::find(std::string_view stage_id) const {
  for (std::size_t i = 0; i < table_->stage_count; ++i) {
    if (table_->stages[i]->id == stage_id) return table_->stages[i];
  }
  return nullptr;
}

Manifest PluginLibrary::describe(const Progress& progress) const {
  Manifest manifest{table_->id, table_->version, {}, {}};
  for (std::size_t i = 0; i < table_->stage_count; ++i) {
    const StageEntry& entry = *table_->stages[i];
    progress(fmt::format("describing its stage '{}'", entry.id));
    StageInfo& info = manifest.stages.emplace_back();
    if (const Outcome outcome = entry.describe(info); !outcome) {
      throw PluginRefused(
          PluginStatus::kFailed,
          fmt::format("Its stage '{}' cannot describe itself: {}.", entry.id, outcome.sentence));
    }
    info.id = entry.id;
  }
  return manifest;
}

}  // namespace stope
