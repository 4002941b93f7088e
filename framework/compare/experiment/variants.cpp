#include "framework/compare/experiment/variants.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <utility>

#include "framework/compare/experiment/codes.hpp"
#include "framework/pipeline/codes.hpp"
#include "framework/pipeline/sentence.hpp"
#include "framework/pipeline/variables.hpp"

namespace stope {
namespace {

constexpr std::size_t kMostVariants = 1000;

bool may_be_in_name(char c) {
  return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' ||
         c == '-' || c == '.' || c == '=' || c == '+';
}

class Reader {
 public:
  Reader(const VariantKind& kind, Diagnostics& diagnostics)
      : kind_(kind), diagnostics_(diagnostics) {}

  std::vector<Variant> read(const LocatedNode& node) {
    if (!node.is_map()) {
      diagnostics_.error(
          code::kWrongKind, node.place,
          fmt::format("'{}s' must be a map, here stands {}.", kind_.one, kind_name(node)),
          "Write 'name: {stage.parameter: value}'.");
      return {};
    }
    if (node.entries.empty())
      diagnostics_.error(code::kWrongKind, node.place,
                         fmt::format("'{}s' names no {}.", kind_.one, kind_.one),
                         "Write 'name: {stage.parameter: value}'.");
    for (const LocatedEntry& entry : node.entries) {
      if (entry.key == "cross") {
        add_cross(entry);
      } else if (auto variant = variant_of(entry.key, entry.place, entry.value)) {
        add(*std::move(variant));
      }
    }
    return std::move(variants_);
  }

 private:
  std::optional<Variant> variant_of(const std::string& name, const Place& place,
                                    const LocatedNode& changes) {
    Variant variant;
    variant.name = name;
    variant.place = place;
    if (name.empty() || name[0] == '.' || !std::all_of(name.begin(), name.end(), may_be_in_name)) {
      diagnostics_.error(
          code::kInvalidName, place,
          fmt::format("'{}' cannot be the name of {}.", shown(name), with_article()),
          "It is a folder's name too: use letters, digits, '_', '-', '.', '=' and '+'.");
      return std::nullopt;
    }
    if (changes.is_empty()) return variant;
    if (!changes.is_map()) {
      diagnostics_.error(code::kWrongKind, changes.place,
                         fmt::format("The {} '{}' must be a map of what it changes, here stands "
                                     "{}.",
                                     kind_.one, name, kind_name(changes)),
                         "Write 'stage.use: family/name' or 'vars.name: value' in it.");
      return std::nullopt;
    }
    for (const LocatedEntry& change : changes.entries)
      set(variant, change.key, change.place, change.value);
    return variant;
  }

  void set(Variant& variant, const std::string& key, const Place& place, const LocatedNode& value) {
    if (key == "seed" && kind_.may_set_seed) {
      variant.seed = seed_in(value, diagnostics_);
    } else if (key == "base" && kind_.may_set_base) {
      if (value.is_scalar())
        variant.base = value;
      else
        diagnostics_.error(code::kWrongKind, value.place, "'base' is the path of a pipeline.");
    } else {
      variant.overrides.push_back({key, place, value});
    }
  }

  void add_cross(const LocatedEntry& cross) {
    if (!cross.value.is_map() || cross.value.entries.empty()) {
      diagnostics_.error(
          code::kWrongKind, cross.value.place,
          fmt::format("'cross' must be a map of axes, here stands {}.", kind_name(cross.value)),
          "Write 'stage.parameter: [value, value]', or 'axis: {choice: {…}, …}'.");
      return;
    }
    std::vector<Variant> combinations(1);
    for (const LocatedEntry& axis : cross.value.entries) {
      const std::vector<Variant> choices = choices_of(axis);
      if (choices.empty()) return;  // reported
      std::vector<Variant> longer;
      for (const Variant& so_far : combinations)
        for (const Variant& choice : choices) longer.push_back(both(so_far, choice));
      combinations = std::move(longer);
      if (combinations.size() > kMostVariants) {
        diagnostics_.error(
            code::kTooManyRuns, axis.place,
            fmt::format("This cross makes more than {} {}s.", kMostVariants, kind_.one),
            "Leave out choices.");
        return;
      }
    }
    for (Variant& combination : combinations) {
      combination.place = cross.place;
      add(std::move(combination));
    }
  }

  std::vector<Variant> choices_of(const LocatedEntry& axis) {
    std::vector<Variant> choices;
    if (axis.value.is_map()) {
      for (const LocatedEntry& choice : axis.value.entries)
        if (auto variant = variant_of(choice.key, choice.place, choice.value))
          choices.push_back(*std::move(variant));
    } else if (axis.value.is_sequence()) {
      for (const LocatedNode& value : axis.value.items) {
        Variant choice;
        choice.name = choice_name(axis.key, value);
        set(choice, axis.key, value.place, value);
        choices.push_back(std::move(choice));
      }
    }
    if (choices.empty())
      diagnostics_.error(
          code::kWrongKind, axis.value.place,
          fmt::format("The axis '{}' has no choices: here stands {}.", shown(axis.key),
                      axis.value.is_sequence() ? "an empty list" : kind_name(axis.value)),
          "Write a list of values, or a map of named choices.");
    return choices;
  }

  // `min_clearance=4m` of roads.min_clearance: 4 m; of an id its last part.
  static std::string choice_name(const std::string& key, const LocatedNode& value) {
    const std::string what = key.substr(key.rfind('.') + 1);
    std::string text = flow_text(value);
    if (what == "use") text = text.substr(text.rfind('/') + 1);
    std::erase(text, ' ');
    for (char& c : text)
      if (!may_be_in_name(c)) c = '-';
    return what == "use" ? text : fmt::format("{}={}", what, text);
  }

  static Variant both(Variant first, const Variant& second) {
    if (!first.name.empty()) first.name += '+';
    first.name += second.name;
    first.overrides.insert(first.overrides.end(), second.overrides.begin(), second.overrides.end());
    if (second.base) first.base = second.base;
    if (second.seed) first.seed = second.seed;
    return first;
  }

  void add(Variant variant) {
    const auto same = std::find_if(variants_.begin(), variants_.end(),
                                   [&](const Variant& v) { return v.name == variant.name; });
    if (same == variants_.end()) return variants_.push_back(std::move(variant));
    diagnostics_.error(code::kSameName, variant.place,
                       fmt::format("Two {}s are called '{}'; the other is at {}.", kind_.one,
                                   variant.name, to_text(same->place)),
                       "Give the choices of an axis names: 'axis: {name: {…}, other: {…}}'.");
  }

  std::string with_article() const {
    return fmt::format("{} {}", kind_.one == "arm" ? "an" : "a", kind_.one);
  }

  const VariantKind& kind_;
  Diagnostics& diagnostics_;
  std::vector<Variant> variants_;
};

}  // namespace

std::vector<Variant> read_variants(const LocatedNode& node, const VariantKind& kind,
                                   Diagnostics& diagnostics) {
  return Reader(kind, diagnostics).read(node);
}

std::vector<Override> overrides_in(const LocatedNode& node, Diagnostics& diagnostics) {
  std::vector<Override> overrides;
  if (!node.is_map() && !node.is_empty())
    diagnostics.error(code::kWrongKind, node.place,
                      fmt::format("Here must stand a map of overrides, not {}.", kind_name(node)),
                      "Write 'stage.parameter: value' in it.");
  for (const LocatedEntry& entry : node.entries)
    overrides.push_back({entry.key, entry.place, entry.value});
  return overrides;
}

std::optional<std::uint64_t> seed_in(const LocatedNode& node, Diagnostics& diagnostics) {
  std::uint64_t seed = 0;
  const char* const end = node.text.data() + node.text.size();
  if (node.is_scalar()) {
    const auto read = std::from_chars(node.text.data(), end, seed);
    if (read.ec == std::errc() && read.ptr == end && !node.text.empty()) return seed;
  }
  diagnostics.error(
      code::kNotANumber, node.place,
      fmt::format("A seed is a whole number of 0 or more, not {}.",
                  node.is_scalar() ? fmt::format("'{}'", shown(node.text)) : kind_name(node)));
  return std::nullopt;
}

}  // namespace stope
