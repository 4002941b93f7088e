#include "framework/plugins/plugin_catalogue.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

#include "framework/plugins/elf_file.hpp"
#include "framework/plugins/layout_check.hpp"
#include "framework/plugins/linked_libraries.hpp"
#include "framework/plugins/manifest_check.hpp"
#include "framework/plugins/note_check.hpp"
#include "framework/plugins/open_file.hpp"
#include "framework/plugins/probe.hpp"

namespace stope {

PluginOptions default_plugin_options(const std::vector<std::filesystem::path>& command_line) {
  PluginOptions options;
  options.search = plugin_search(command_line, running_executable());
  options.manifests = manifest_folder();
  return options;
}

PluginCatalogue::PluginCatalogue(PluginOptions options)
    : options_(std::move(options)), cache_(options_.manifests) {
  scan();
  std::sort(stages_.begin(), stages_.end(), [](const StageRecord& a, const StageRecord& b) {
    return std::tie(a.info.id, a.file) < std::tie(b.info.id, b.file);
  });
  settle_conflicts();
}

void PluginCatalogue::scan() {
  const auto layouts = sdk_layouts();
  for (const std::filesystem::path& path : plugin_candidates(options_.search)) {
    PluginFile& file = files_.emplace_back();
    file.path = path;
    try {
      Manifest manifest = examine(path, file);
      check_manifest(manifest);
      check_layouts(manifest, layouts);
      const std::string libraries = builds_of(manifest.libraries);
      for (StageInfo& info : manifest.stages) {
        file.stages.push_back(info.id);
        stages_.push_back(
            {std::move(info), path, file.plugin_id, file.plugin_version, file.build_id, libraries});
      }
      std::sort(file.stages.begin(), file.stages.end());
    } catch (const PluginRefused& refused) {
      file.status = refused.status();
      file.sentence = refused.what();
    }
  }
}

Manifest PluginCatalogue::examine(const std::filesystem::path& path, PluginFile& file) {
  const OpenFile open(path);
  const ElfNotes notes = read_elf(open);
  file.build_id = notes.build_id;
  if (notes.complete) {
    file.plugin_id = notes.stope->plugin_id;
    file.plugin_version = notes.stope->plugin_version;
  }
  check_note(notes);
  // Without it a rebuilt plugin would pass for the one before.
  if (file.build_id.empty()) file.build_id = open.digest();
  const FileIdentity identity{path.string(), open.size(), open.modified(), file.build_id,
                              linker_environment()};
  identities_[path.string()] = identity;
  if (auto manifest = cache_.find(identity); manifest && are_unchanged(manifest->libraries)) {
    file.cached = true;
    return std::move(*manifest);
  }
  Manifest manifest = probe_plugin(path, options_.probe_limit);
  cache_.keep(identity, manifest);
  return manifest;
}

void PluginCatalogue::settle_conflicts() {
  for (auto first = stages_.begin(); first != stages_.end();) {
    const std::string id = first->info.id;
    const auto last =
        std::find_if(first, stages_.end(), [&id](const StageRecord& s) { return s.info.id != id; });
    if (last - first == 1) {
      first = last;
      continue;
    }
    std::string names;
    for (auto record = first; record != last; ++record) {
      names += (names.empty() ? "" : " and ") + record->file.string();
    }
    const std::string sentence = fmt::format(
        "The stage '{}' is offered by {}: neither is used. Remove one of the files.", id, names);
    conflicts_[id] = sentence;
    for (PluginFile& file : files_) {
      if (std::erase(file.stages, id) == 0) continue;
      file.status = PluginStatus::kDuplicateStage;
      file.sentence += (file.sentence.empty() ? "" : " ") + sentence;
    }
    first = stages_.erase(first, last);
  }
}

const StageRecord* PluginCatalogue::find(std::string_view id) const {
  const auto found = std::lower_bound(
      stages_.begin(), stages_.end(), id,
      [](const StageRecord& stage, std::string_view key) { return stage.info.id < key; });
  return found != stages_.end() && found->info.id == id ? &*found : nullptr;
}

std::string PluginCatalogue::conflict(std::string_view id) const {
  const auto found = conflicts_.find(id);
  return found == conflicts_.end() ? "" : found->second;
}

const PluginLibrary& PluginCatalogue::library(const StageRecord& stage) const {
  const std::string path = stage.file.string();
  const std::lock_guard lock(mutex_);
  if (const auto open = libraries_.find(path); open != libraries_.end()) return open->second;
  const OpenFile file(stage.file);
  const FileIdentity& judged = identities_.at(path);
  if (file.size() != judged.size || file.modified() != judged.modified) {
    throw Error("it was replaced after it had been found fit; run again");
  }
  return libraries_.emplace(path, PluginLibrary(stage.file)).first->second;
}

std::unique_ptr<StageInstance> PluginCatalogue::create(std::string_view id) const {
  if (const std::string sentence = conflict(id); !sentence.empty()) throw Error(sentence);
  const StageRecord* stage = find(id);
  if (!stage) throw Error(fmt::format("No plugin offers a stage '{}'.", id));
  const std::string path = stage->file.string();
  std::unique_ptr<StageInstance> instance;
  try {
    const StageEntry* entry = library(*stage).find(id);
    if (!entry) throw Error("it no longer offers the stage; run again");
    if (const Outcome outcome = entry->create(instance); !outcome) {
      throw Error(fmt::format("its stage '{}' cannot be made: {}", id, outcome.sentence));
    }
  } catch (const Error& error) {
    throw Error(fmt::format("{}: {}", path, error.what()));
  }
  return instance;
}

}  // namespace stope
