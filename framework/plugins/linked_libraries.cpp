// Problem: a result must not pass for what it is no longer once a library that its plugin is linked
// with has been upgraded, and asking must not take opening the plugin.
// Idea: what the dynamic linker found is noted where the plugin is opened anyway, in the probe. As
// long as these files are the same by size and times, so are their builds; if not, the plugin is
// probed again.
// Cost: one stat() a library.
#include "framework/plugins/linked_libraries.hpp"

#include <sys/stat.h>

#include <cstdlib>
#include <map>
#include <optional>
#include <set>

#include "framework/plugins/open_file.hpp"
#include "framework/plugins/plugin_file.hpp"
#include "framework/plugins/sdk_build.hpp"
#include "stope/digest.hpp"

namespace stope {
namespace {

std::int64_t nanoseconds(const timespec& time) {
  return std::int64_t{time.tv_sec} * 1'000'000'000 + time.tv_nsec;
}

/// Without its build; none if there is no such file.
std::optional<LinkedLibrary> library_at(const std::string& file) {
  struct stat status {};
  if (::stat(file.c_str(), &status) != 0) return std::nullopt;
  return LinkedLibrary{file,
                       static_cast<std::uint64_t>(status.st_size),
                       nanoseconds(status.st_mtim),
                       nanoseconds(status.st_ctim),
                       {}};
}

std::string build_of(const LoadedObject& object) {
  if (!object.build_id.empty()) return object.build_id;
  try {
    return OpenFile(object.file).digest();
  } catch (const PluginRefused&) {
    return {};  // removed since it was loaded: there is no such file the next time either
  }
}

}  // namespace

std::vector<LinkedLibrary> linked_libraries(const std::filesystem::path& plugin) {
  std::map<std::string, LoadedObject> by_name;
  std::vector<std::string> open;
  for (LoadedObject& object : loaded_objects()) {
    if (object.file == plugin.string()) open = object.needed;
    by_name.emplace(object.name, std::move(object));
  }
  std::set<std::string> found;
  while (!open.empty()) {
    const std::string name = std::move(open.back());
    open.pop_back();
    const auto object = by_name.find(name);
    if (object == by_name.end() || is_sdk(object->second) || !found.insert(name).second) continue;
    open.insert(open.end(), object->second.needed.begin(), object->second.needed.end());
  }
  std::vector<LinkedLibrary> libraries;
  for (const std::string& name : found) {
    const LoadedObject& object = by_name.at(name);
    libraries.push_back(library_at(object.file).value_or(LinkedLibrary{object.file, 0, 0, 0, {}}));
    libraries.back().build = build_of(object);
  }
  return libraries;
}

bool are_unchanged(const std::vector<LinkedLibrary>& libraries) {
  for (const LinkedLibrary& known : libraries) {
    auto now = library_at(known.file);
    if (!now) return false;
    now->build = known.build;
    if (*now != known) return false;
  }
  return true;
}

std::string builds_of(const std::vector<LinkedLibrary>& libraries) {
  if (libraries.empty()) return {};
  Digester digester;
  for (const LinkedLibrary& library : libraries) {
    encode(std::filesystem::path(library.file).filename().string(), digester);
    encode(library.build, digester);
  }
  return digester.digest().text();
}

std::string linker_environment() {
  std::string text;
  for (const char* name : {"LD_LIBRARY_PATH", "LD_PRELOAD"})
    if (const char* value = std::getenv(name)) text += std::string(name) + "=" + value + "\n";
  return text;
}

}  // namespace stope
