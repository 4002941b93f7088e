#include "framework/plugins/plugin_search.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <set>
#include <system_error>

namespace stope {

namespace {

namespace fs = std::filesystem;

/// A folder of the XDG base directory specification, which asks to ignore relative values.
std::optional<fs::path> xdg_folder(const Environment& environment, const std::string& variable,
                                   const fs::path& below_home) {
  if (const auto value = environment(variable); value && fs::path(*value).is_absolute()) {
    return *value;
  }
  if (const auto home = environment("HOME"); home && fs::path(*home).is_absolute()) {
    return fs::path(*home) / below_home;
  }
  return std::nullopt;
}

std::vector<std::string> split_at_colons(const std::string& text) {
  std::vector<std::string> parts;
  std::size_t begin = 0;
  for (;;) {
    const std::size_t end = text.find(':', begin);
    parts.push_back(text.substr(begin, end - begin));
    if (end == std::string::npos) return parts;
    begin = end + 1;
  }
}

class Places {
 public:
  /// Adds a place that a person named: it is worth a warning if it is missing.
  void add_named(const fs::path& place, const std::string& where) {
    if (add(place)) return;
    search_.warnings.push_back(fmt::format(
        "There is no plugin folder {} ({} names it); it is skipped.", place.string(), where));
  }
  void warn(std::string sentence) { search_.warnings.push_back(std::move(sentence)); }

  bool add(const fs::path& place) {
    std::error_code error;
    const fs::path canonical = fs::canonical(place, error);
    if (error) return false;
    if (std::find(search_.places.begin(), search_.places.end(), canonical) ==
        search_.places.end()) {
      search_.places.push_back(canonical);
    }
    return true;
  }

  PluginSearch take() { return std::move(search_); }

 private:
  PluginSearch search_;
};

}  // namespace

Environment process_environment() {
  return [](const std::string& name) -> std::optional<std::string> {
    const char* value = std::getenv(name.c_str());
    if (value == nullptr) return std::nullopt;
    return value;
  };
}

PluginSearch plugin_search(const std::vector<fs::path>& command_line, const fs::path& executable,
                           const Environment& environment) {
  Places places;
  for (const fs::path& place : command_line) places.add_named(place, "--plugin-path");
  for (const std::string& part : split_at_colons(environment("STOPE_PLUGIN_PATH").value_or(""))) {
    if (part.empty()) continue;
    if (fs::path(part).is_absolute()) {
      places.add_named(part, "STOPE_PLUGIN_PATH");
    } else {
      places.warn(
          fmt::format("STOPE_PLUGIN_PATH names {}, which is not an absolute path; it is "
                      "skipped, since what it means would change with the folder one is in.",
                      part));
    }
  }
  if (const auto data = xdg_folder(environment, "XDG_DATA_HOME", ".local/share")) {
    places.add(*data / "stope" / "plugins");
  }
  if (executable.is_absolute()) {
    places.add(executable.parent_path() / ".." / "lib" / "stope" / "plugins");
  }
  return places.take();
}

fs::path running_executable() {
  std::error_code error;
  return fs::read_symlink("/proc/self/exe", error);
}

std::optional<fs::path> manifest_folder(const Environment& environment) {
  const auto cache = xdg_folder(environment, "XDG_CACHE_HOME", ".cache");
  if (!cache) return std::nullopt;
  return *cache / "stope" / "manifests";
}

std::vector<fs::path> plugin_candidates(PluginSearch& search) {
  std::vector<fs::path> candidates;
  std::set<fs::path> seen;
  const auto add = [&](const fs::path& file) {
    std::error_code error;
    const fs::path canonical = fs::canonical(file, error);
    if (seen.insert(error ? file : canonical).second) candidates.push_back(file);
  };
  for (const fs::path& place : search.places) {
    std::error_code error;
    if (!fs::is_directory(place, error)) {
      add(place);
      continue;
    }
    std::vector<fs::path> files;
    for (fs::directory_iterator entry(place, error), end; !error && entry != end;
         entry.increment(error)) {
      std::error_code ignored;
      if (entry->path().extension() == ".so" && !entry->is_directory(ignored)) {
        files.push_back(entry->path());
      }
    }
    if (error) {
      search.warnings.push_back(
          fmt::format("The plugin folder {} cannot be read ({}); it is skipped.", place.string(),
                      error.message()));
    }
    std::sort(files.begin(), files.end());
    for (const fs::path& file : files) add(file);
  }
  return candidates;
}

}  // namespace stope
