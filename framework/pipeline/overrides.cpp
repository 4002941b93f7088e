#include "framework/pipeline/overrides.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <string_view>
#include <utility>

#include "framework/pipeline/codes.hpp"
#include "framework/pipeline/sentence.hpp"
#include "framework/pipeline/variables.hpp"
#include "framework/pipeline/yaml_reader.hpp"

namespace stope {
namespace {

LocatedNode empty_map(const Place& place, const std::string& folder) {
  LocatedNode node;
  node.kind = LocatedNode::Kind::kMap;
  node.place = place;
  node.folder = folder;
  return node;
}

LocatedNode& child_map(LocatedNode& parent, const std::string& key, const Place& place) {
  if (LocatedEntry* entry = parent.find(key)) {
    if (entry->value.is_empty()) entry->value = empty_map(place, parent.folder);
    return entry->value;
  }
  parent.entries.push_back({key, place, empty_map(place, parent.folder)});
  return parent.entries.back().value;
}

void put(LocatedNode& map, const std::string& key, const Place& place, LocatedNode value) {
  if (LocatedEntry* entry = map.find(key)) {
    entry->place = place;
    entry->value = std::move(value);
  } else {
    map.entries.push_back({key, place, std::move(value)});
  }
}

std::vector<std::string> split_key(std::string_view key) {
  std::vector<std::string> parts;
  for (;;) {
    const auto dot = key.find('.');
    parts.emplace_back(key.substr(0, dot));
    if (dot == std::string_view::npos) return parts;
    key.remove_prefix(dot + 1);
  }
}

constexpr const char* kHowToSet =
    "Write --set stage.parameter=value, --set stage.use=family/name or --set vars.name=value.";

// The value of the `--set` at `place`.
std::optional<LocatedNode> parse(const std::string& text, const std::string& value,
                                 const Place& place, Diagnostics& diagnostics) {
  std::error_code problem;
  const SourceText source(value, place, std::filesystem::current_path(problem).string());
  if (value.find_first_not_of(" \t") == std::string::npos) {
    LocatedNode nothing;
    nothing.place = place;
    return nothing;
  }
  Diagnostics found;
  std::optional<LocatedNode> node;
  if (check_source(source, found)) node = read_yaml(source, found);
  // `null` is a value here.
  if (!node && found.sorted().size() == 1 && found.sorted()[0].code == code::kEmptyFile)
    return parse(text, "", place, diagnostics);
  if (!found.has_errors()) return node;
  for (const Diagnostic& problem_found : found.sorted())
    diagnostics.error(
        code::kMalformedOverride, place,
        fmt::format("The value in '{}' cannot be read: {}", shown(text), problem_found.sentence),
        problem_found.hint);
  return std::nullopt;
}

class Application {
 public:
  Application(LocatedNode& root, const Override& change, Diagnostics& diagnostics)
      : root_(root), change_(change), place_(change.place), diagnostics_(diagnostics) {}

  void apply() {
    const std::vector<std::string> parts = split_key(change_.key);
    const bool by_member = parts.size() == 3 && parts[1].find('/') != std::string::npos;
    if ((parts.size() != 2 && !by_member) ||
        std::any_of(parts.begin(), parts.end(), [](const auto& part) { return part.empty(); }))
      return malformed();
    if (parts[0] == "vars") return set_variable(parts[1], change_.value);
    LocatedEntry* stages = root_.find("stages");
    LocatedEntry* stage = stages ? stages->value.find(parts[0]) : nullptr;
    if (!stage) return unknown_stage(parts[0], stages);
    if (!stage->value.is_map()) return;  // reported where the file says so
    if (parts[1] == "use" || parts[1] == "in")
      return put(stage->value, parts[1], place_, change_.value);
    LocatedNode& parameters = child_map(stage->value, "params", place_);
    if (!parameters.is_map()) return;
    if (by_member)
      return put(child_map(parameters, parts[1], place_), parts[2], place_, change_.value);
    // What is set here wins over what the file keeps for single members.
    for (LocatedEntry& entry : parameters.entries)
      if (entry.key.find('/') != std::string::npos)
        std::erase_if(entry.value.entries, [&](const auto& e) { return e.key == parts[1]; });
    put(parameters, parts[1], place_, change_.value);
  }

 private:
  void malformed() {
    diagnostics_.error(
        code::kMalformedOverride, place_,
        fmt::format("'{}' does not name a variable or a parameter.", shown(change_.key)),
        place_.file == "--set" ? kHowToSet
                               : "Write stage.parameter, stage.use, stage.in or vars.name.");
  }

  void set_variable(const std::string& name, LocatedNode value) {
    const LocatedEntry* vars = std::as_const(root_).find("vars");
    const std::vector<std::string> used = referenced_variables(root_);
    if (!(vars && vars->value.find(name)) &&
        std::find(used.begin(), used.end(), name) == used.end()) {
      std::vector<std::string> names = vars ? vars->value.keys() : std::vector<std::string>();
      names.insert(names.end(), used.begin(), used.end());
      std::sort(names.begin(), names.end());
      names.erase(std::unique(names.begin(), names.end()), names.end());
      diagnostics_.error(
          code::kOverridesNothing, place_,
          fmt::format("The pipeline has no variable '{}'.", shown(name)),
          did_you_mean(name, names,
                       names.empty() ? "It has none at all."
                                     : fmt::format("It has {}.", quoted_list(names))));
      return;
    }
    put(child_map(root_, "vars", place_), name, place_, std::move(value));
  }

  void unknown_stage(const std::string& name, const LocatedEntry* stages) {
    std::vector<std::string> names = stages ? stages->value.keys() : std::vector<std::string>();
    const std::string all = quoted_list(names);
    names.emplace_back("vars");
    diagnostics_.error(
        code::kOverridesNothing, place_,
        fmt::format("The pipeline has no stage '{}'.", shown(name)),
        did_you_mean(name, names, all.empty() ? "" : fmt::format("It has {}.", all)));
  }

  LocatedNode& root_;
  const Override& change_;
  const Place& place_;
  Diagnostics& diagnostics_;
};

}  // namespace

void apply_overrides(LocatedNode& root, const std::vector<Override>& overrides,
                     Diagnostics& diagnostics) {
  for (const Override& change : overrides) Application(root, change, diagnostics).apply();
}

std::vector<Override> read_overrides(const std::vector<std::string>& texts,
                                     Diagnostics& diagnostics) {
  std::vector<Override> overrides;
  for (std::size_t i = 0; i < texts.size(); ++i) {
    const Place place{"--set", static_cast<int>(i) + 1, 0};
    const auto equals = texts[i].find('=');
    if (equals == std::string::npos) {
      diagnostics.error(code::kMalformedOverride, place,
                        fmt::format("'{}' has no '='.", shown(texts[i])), kHowToSet);
      continue;
    }
    if (auto value = parse(texts[i], texts[i].substr(equals + 1), place, diagnostics))
      overrides.push_back({texts[i].substr(0, equals), place, *std::move(value)});
  }
  return overrides;
}

}  // namespace stope
