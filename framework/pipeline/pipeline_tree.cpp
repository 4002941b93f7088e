#include "framework/pipeline/pipeline_tree.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

#include "framework/pipeline/codes.hpp"
#include "framework/pipeline/merge.hpp"
#include "framework/pipeline/sentence.hpp"
#include "framework/pipeline/yaml_reader.hpp"

namespace stope {
namespace {

class Loader {
 public:
  explicit Loader(Diagnostics& diagnostics) : diagnostics_(diagnostics) {}

  // The file's own tree with its includes below it.
  std::optional<LocatedNode> load(const SourceText& source, const std::string& identity) {
    std::optional<LocatedNode> own = read_yaml(source, diagnostics_);
    if (!own) return std::nullopt;
    if (!own->is_map()) {
      diagnostics_.error(code::kWrongKind, own->place,
                         fmt::format("A pipeline is a map; this file holds {}.", kind_name(*own)),
                         "It begins with 'stope: 1' and lists its stages under 'stages:'.");
      return std::nullopt;
    }
    check_top(*own, open_.empty());
    open_.push_back({identity, source.file().file});
    LocatedNode below;
    below.kind = LocatedNode::Kind::kMap;
    below.place = own->place;
    for (const LocatedNode& asked : included(*own))
      if (const LocatedNode* tree = include(asked))
        merge_included(below, *tree, *own, diagnostics_);
    open_.pop_back();
    overlay(below, *own);
    return below;
  }

  std::vector<std::filesystem::path> files;

 private:
  struct OpenFile {
    std::string identity, name;
  };

  void check_top(LocatedNode& root, bool is_pipeline) {
    static const std::vector<std::string> kKeys{"stope", "name",   "include",
                                                "vars",  "stages", "outputs"};
    for (const LocatedEntry& entry : root.entries)
      if (std::find(kKeys.begin(), kKeys.end(), entry.key) == kKeys.end())
        diagnostics_.error(code::kUnknownKey, entry.place,
                           fmt::format("A pipeline has no key '{}'; it has {}.", shown(entry.key),
                                       quoted_list(kKeys)),
                           did_you_mean(entry.key, kKeys));
    for (const char* key : {"vars", "stages", "outputs"}) {
      const LocatedEntry* entry = std::as_const(root).find(key);
      if (!entry || entry->value.is_map()) continue;
      const std::string example = std::string(key) == "vars"     ? "name: value"
                                  : std::string(key) == "stages" ? "name: {use: family/name}"
                                                                 : "name.extension: stage";
      if (entry->value.is_empty()) {
        if (std::string(key) == "stages")
          diagnostics_.error(code::kNoValue, entry->value.place, "Nothing is listed under stages:.",
                             fmt::format("Write '{}'.", example));
      } else {
        diagnostics_.error(
            code::kWrongKind, entry->value.place,
            fmt::format("'{}' must be a map, here stands {}.", key, kind_name(entry->value)),
            fmt::format("Write '{}'.", example));
      }
      std::erase_if(root.entries, [&](const LocatedEntry& e) { return e.key == key; });
      broken_section_ = broken_section_ || std::string(key) == "stages";
    }
    check_version(root, is_pipeline);
    if (is_pipeline && !broken_section_ && !root.find("stages") && !root.find("include"))
      diagnostics_.error(code::kMissingKey, {root.place.file, 0, 0}, "This pipeline has no stages.",
                         "List them under 'stages:', each as 'name: {use: family/name}'.");
  }

  void check_version(const LocatedNode& root, bool is_pipeline) {
    const LocatedEntry* version = root.find("stope");
    if (!version) {
      if (is_pipeline)
        diagnostics_.error(code::kMissingKey, {root.place.file, 0, 0},
                           "This file does not say which version of the format it is written in.",
                           "Begin it with 'stope: 1'.");
      return;
    }
    if (version->value.is_scalar() && version->value.text == "1") return;
    diagnostics_.error(code::kWrongVersion, version->value.place,
                       version->value.is_scalar()
                           ? fmt::format("This Stope reads version 1 of pipeline files, not '{}'.",
                                         shown(version->value.text))
                           : std::string("'stope' must be the version of the format."),
                       "Write 'stope: 1'.");
  }

  std::vector<LocatedNode> included(const LocatedNode& root) {
    const LocatedEntry* entry = root.find("include");
    if (!entry) return {};
    std::vector<LocatedNode> paths;
    if (entry->value.is_sequence()) {
      paths = entry->value.items;
    } else {
      paths.push_back(entry->value);
    }
    std::erase_if(paths, [&](const LocatedNode& path) {
      if (path.is_scalar() && path.text.find("${") == std::string::npos && !path.text.empty())
        return false;
      diagnostics_.error(code::kWrongKind, path.place,
                         path.is_scalar() && !path.text.empty()
                             ? "The path of an included file cannot hold variables, because files "
                               "are included before variables are known."
                             : fmt::format("'include' takes the path of a file, or a list of "
                                           "paths; here stands {}.",
                                           path.is_scalar() ? "an empty text" : kind_name(path)),
                         "Write 'include: common.yaml' or 'include: [a.yaml, b.yaml]'.");
      return true;
    });
    return paths;
  }

  const LocatedNode* include(const LocatedNode& asked) {
    std::filesystem::path file = asked.text;
    if (file.is_relative()) file = std::filesystem::path(asked.folder) / file;
    file = file.lexically_normal();
    std::error_code problem;
    const auto canonical = std::filesystem::weakly_canonical(file, problem);
    const std::string identity = problem ? file.string() : canonical.string();
    const auto open = std::find_if(open_.begin(), open_.end(),
                                   [&](const OpenFile& o) { return o.identity == identity; });
    if (open != open_.end()) {
      std::string chain;
      for (auto i = open; i != open_.end(); ++i)
        chain.append(std::filesystem::path(i->name).filename().string()).append(" -> ");
      diagnostics_.error(
          code::kIncludeCycle, asked.place,
          fmt::format("This file includes itself: {}{}.", chain, file.filename().string()),
          "Remove this include.");
      return nullptr;
    }
    if (const auto known = trees_.find(identity); known != trees_.end())
      return known->second ? &*known->second : nullptr;
    const auto shown_file = display_path(file, asked);
    std::optional<LocatedNode> tree;
    if (std::optional<SourceText> source = read_source(shown_file, asked.place, diagnostics_)) {
      files.push_back(file);
      tree = load(*source, identity);
    }
    const auto& kept = trees_.emplace(identity, std::move(tree)).first->second;
    return kept ? &*kept : nullptr;
  }

  // As the including file is named, so that `dir/a.yaml` includes `dir/b.yaml`, not `/home/…`.
  static std::filesystem::path display_path(const std::filesystem::path& file,
                                            const LocatedNode& asked) {
    const std::filesystem::path text = asked.text;
    const std::filesystem::path parent = std::filesystem::path(asked.place.file).parent_path();
    if (text.is_absolute()) return file;
    return (parent / text).lexically_normal();
  }

  Diagnostics& diagnostics_;
  std::vector<OpenFile> open_;  ///< files being included, outermost first
  std::map<std::string, std::optional<LocatedNode>> trees_;
  bool broken_section_ = false;
};

}  // namespace

std::optional<PipelineTree> load_pipeline(const SourceText& source, Diagnostics& diagnostics) {
  Loader loader(diagnostics);
  std::error_code problem;
  const std::filesystem::path file = source.file().file;
  const auto canonical = std::filesystem::weakly_canonical(file, problem);
  std::optional<LocatedNode> root =
      loader.load(source, problem ? file.string() : canonical.string());
  if (!root) return std::nullopt;
  PipelineTree tree;
  tree.root = std::move(*root);
  tree.files.push_back(file);
  tree.files.insert(tree.files.end(), loader.files.begin(), loader.files.end());
  return tree;
}

}  // namespace stope
