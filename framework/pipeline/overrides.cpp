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

class Override {
 public:
  Override(LocatedNode& root, const std::string& text, std::size_t number, Diagnostics& diagnostics)
      : root_(root), text_(text), diagnostics_(diagnostics) {
    place_ = {"--set", static_cast<int>(number), 0};
  }

  void apply() {
    const auto equals = text_.find('=');
    if (equals == std::string::npos)
      return malformed(fmt::format("'{}' has no '='.", shown(text_)));
    const std::vector<std::string> parts = split_key(std::string_view(text_).substr(0, equals));
    const bool by_member = parts.size() == 3 && parts[1].find('/') != std::string::npos;
    if ((parts.size() != 2 && !by_member) ||
        std::any_of(parts.begin(), parts.end(), [](const auto& part) { return part.empty(); }))
      return malformed(fmt::format("'{}' does not name a variable or a parameter.",
                                   shown(text_.substr(0, equals))));
    std::optional<LocatedNode> value = parse(text_.substr(equals + 1));
    if (!value) return;
    if (parts[0] == "vars") return set_variable(parts[1], std::move(*value));
    LocatedEntry* stages = root_.find("stages");
    LocatedEntry* stage = stages ? stages->value.find(parts[0]) : nullptr;
    if (!stage) return unknown_stage(parts[0], stages);
    if (!stage->value.is_map()) return;  // reported where the file says so
    if (parts[1] == "use" || parts[1] == "in")
      return put(stage->value, parts[1], place_, std::move(*value));
    LocatedNode& parameters = child_map(stage->value, "params", place_);
    if (!parameters.is_map()) return;
    if (by_member)
      return put(child_map(parameters, parts[1], place_), parts[2], place_, std::move(*value));
    // What is set here wins over what the file keeps for single members.
    for (LocatedEntry& entry : parameters.entries)
      if (entry.key.find('/') != std::string::npos)
        std::erase_if(entry.value.entries, [&](const auto& e) { return e.key == parts[1]; });
    put(parameters, parts[1], place_, std::move(*value));
  }

 private:
  void malformed(std::string sentence) {
    diagnostics_.error(code::kMalformedOverride, place_, std::move(sentence),
                       "Write --set stage.parameter=value, --set stage.use=family/name or "
                       "--set vars.name=value.");
  }

  std::optional<LocatedNode> parse(const std::string& text) {
    std::error_code problem;
    const SourceText source(text, place_, std::filesystem::current_path(problem).string());
    if (text.find_first_not_of(" \t") == std::string::npos) {
      LocatedNode nothing;
      nothing.place = place_;
      return nothing;
    }
    Diagnostics found;
    std::optional<LocatedNode> value;
    if (check_source(source, found)) value = read_yaml(source, found);
    // `null` is a value here.
    if (!value && found.sorted().size() == 1 && found.sorted()[0].code == code::kEmptyFile)
      return parse("");
    if (!found.has_errors()) return value;
    for (const Diagnostic& problem_found : found.sorted())
      diagnostics_.error(
          code::kMalformedOverride, place_,
          fmt::format("The value in '{}' cannot be read: {}", shown(text_), problem_found.sentence),
          problem_found.hint);
    return std::nullopt;
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
  const std::string& text_;
  Diagnostics& diagnostics_;
  Place place_;
};

}  // namespace

void apply_overrides(LocatedNode& root, const std::vector<std::string>& overrides,
                     Diagnostics& diagnostics) {
  for (std::size_t i = 0; i < overrides.size(); ++i)
    Override(root, overrides[i], i + 1, diagnostics).apply();
}

}  // namespace stope
