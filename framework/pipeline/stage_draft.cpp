#include "framework/pipeline/stage_draft.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "framework/pipeline/codes.hpp"
#include "framework/pipeline/sentence.hpp"
#include "framework/pipeline/wire_reader.hpp"

namespace stope {
namespace {

const std::vector<std::string> kBodyKeys{"use", "in", "params"};

// The key that a person who wrote another one most likely meant, or nothing.
std::string meant_key(const std::string& key) {
  struct Synonym {
    const char *word, *key;
  };
  for (const Synonym& synonym : {Synonym{"type", "use"},
                                 {"stage", "use"},
                                 {"plugin", "use"},
                                 {"input", "in"},
                                 {"inputs", "in"},
                                 {"from", "in"},
                                 {"parameters", "params"},
                                 {"args", "params"}})
    if (key == synonym.word) return synonym.key;
  return nearest_name(key, kBodyKeys);
}

bool is_stage_name(const std::string& name) {
  const auto letter = [](char c) {
    return c == '_' || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
  };
  return !name.empty() && letter(name[0]) && std::all_of(name.begin(), name.end(), [&](char c) {
    return letter(c) || c == '-' || (c >= '0' && c <= '9');
  });
}

bool check_name(const LocatedEntry& entry, Diagnostics& diagnostics) {
  if (entry.key == "vars" || entry.key == "use" || entry.key == "in") {
    diagnostics.error(
        code::kReservedName, entry.place,
        fmt::format("A stage cannot be called '{}'; that word is taken by --set.", entry.key),
        "Give it another name.");
    return false;
  }
  if (is_stage_name(entry.key)) return true;
  diagnostics.error(code::kInvalidName, entry.place,
                    fmt::format("A stage cannot be called '{}'.", shown(entry.key)),
                    "Names have letters, digits, '_' and '-', and begin with a letter or '_'.");
  return false;
}

std::string hint_for_unknown(const std::string& id, const Catalogue& catalogue) {
  std::vector<std::string> ids, families;
  for (const StageRecord& record : catalogue.stages()) {
    ids.push_back(record.info.id);
    const std::string family = family_of(record.info.id);
    if (families.empty() || families.back() != family) families.push_back(family);
    // `watershed` for `topology/watershed`.
    if (record.info.id.substr(family.size()) == id)
      return fmt::format("Did you mean '{}'?", record.info.id);
  }
  const std::vector<std::string> members = members_of(catalogue, family_of(id));
  std::string otherwise;
  if (ids.empty()) {
    otherwise = "No plugin was found at all.";
  } else if (!members.empty()) {
    otherwise = fmt::format("The family {} has {}.", family_of(id), quoted_list(members));
  } else {
    otherwise = fmt::format("The families are {}; 'stope stages' lists all stages.",
                            quoted_list(families, "and", 20));
  }
  return did_you_mean(id, ids, otherwise);
}

void read_use(StageDraft& draft, const LocatedNode& body, const Catalogue& catalogue,
              Diagnostics& diagnostics) {
  const LocatedEntry* use = body.find("use");
  if (!use) {
    const bool misspelt =
        std::any_of(body.entries.begin(), body.entries.end(),
                    [](const LocatedEntry& entry) { return meant_key(entry.key) == "use"; });
    if (!draft.is_export && !body.incomplete && !misspelt)
      diagnostics.error(code::kMissingKey, body.place,
                        fmt::format("{} does not say which stage it uses.", draft.subject()),
                        "Add 'use: family/name'.");
    return;
  }
  draft.use_place = use->value.place;
  if (use->value.broken) return;
  if (!use->value.is_scalar() || use->value.text.empty()) {
    diagnostics.error(use->value.is_empty() ? code::kNoValue : code::kWrongKind, use->value.place,
                      fmt::format("'use' must name a stage; here stands {}.",
                                  use->value.is_scalar() ? "an empty text" : kind_name(use->value)),
                      "Write 'use: family/name'.");
    return;
  }
  draft.use = use->value.text;
  draft.record = catalogue.find(draft.use);
  if (!draft.record)
    diagnostics.error(code::kUnknownStage, draft.use_place,
                      fmt::format("No plugin offers the stage '{}'.", shown(draft.use)),
                      hint_for_unknown(draft.use, catalogue));
}

void check_keys(const StageDraft& draft, const LocatedNode& body, Diagnostics& diagnostics) {
  for (const LocatedEntry& entry : body.entries) {
    if (std::find(kBodyKeys.begin(), kBodyKeys.end(), entry.key) != kBodyKeys.end()) continue;
    const std::string meant = meant_key(entry.key);
    std::string hint = meant.empty() ? "" : fmt::format("Did you mean '{}'?", meant);
    if (draft.record)
      for (const ParameterInfo& parameter : draft.record->info.parameters)
        if (parameter.name == entry.key)
          hint = fmt::format("It is a parameter of {}: write 'params: {{{}: …}}'.", draft.use,
                             entry.key);
    diagnostics.error(code::kUnknownKey, entry.place,
                      fmt::format("A stage has no key '{}'; it has {}.", shown(entry.key),
                                  quoted_list(kBodyKeys)),
                      hint);
  }
}

}  // namespace

std::string StageDraft::subject() const {
  const char* what = is_export ? "Output" : "Stage";
  return use.empty() ? fmt::format("{} '{}'", what, name)
                     : fmt::format("{} '{}' ({})", what, name, use);
}

std::string family_of(const std::string& id) {
  const auto slash = id.find('/');
  return slash == std::string::npos ? std::string() : id.substr(0, slash + 1);
}

std::vector<std::string> members_of(const Catalogue& catalogue, const std::string& family) {
  std::vector<std::string> ids;
  for (const StageRecord& record : catalogue.stages())
    if (!family.empty() && record.info.id.starts_with(family)) ids.push_back(record.info.id);
  return ids;
}

void read_body(StageDraft& draft, const LocatedNode& body, const Catalogue& catalogue,
               Diagnostics& diagnostics) {
  read_use(draft, body, catalogue, diagnostics);
  check_keys(draft, body, diagnostics);
  if (const LocatedEntry* in = body.find("in")) read_wires(draft, in->value, diagnostics);
  if (const LocatedEntry* params = body.find("params")) {
    if (params->value.is_map()) {
      draft.params = &params->value;
    } else if (!params->value.is_empty() && !params->value.broken) {
      diagnostics.error(code::kWrongKind, params->value.place,
                        fmt::format("'params' must be a map of parameters; here stands {}.",
                                    kind_name(params->value)),
                        "Write 'params: {name: value}'.");
    }
  }
  if (draft.record) {
    draft.inputs.resize(draft.record->info.inputs.size());
    draft.input_places.resize(draft.record->info.inputs.size());
  }
}

std::vector<StageDraft> draft_stages(const LocatedNode* stages, const Catalogue& catalogue,
                                     Diagnostics& diagnostics) {
  std::vector<StageDraft> drafts;
  if (!stages) return drafts;
  for (const LocatedEntry& entry : stages->entries) {
    check_name(entry, diagnostics);
    StageDraft draft;
    draft.name = entry.key;
    draft.place = entry.place;
    if (entry.value.is_map()) {
      read_body(draft, entry.value, catalogue, diagnostics);
    } else if (!entry.value.broken) {
      const bool id = entry.value.is_scalar() && entry.value.text.find('/') != std::string::npos;
      diagnostics.error(entry.value.is_empty() ? code::kNoValue : code::kWrongKind,
                        entry.value.place,
                        fmt::format("Stage '{}' must be a map; here stands {}.", shown(entry.key),
                                    kind_name(entry.value)),
                        fmt::format("Write '{}: {{use: {}}}'.", shown(entry.key),
                                    id ? shown(entry.value.text) : "family/name"));
    }
    drafts.push_back(std::move(draft));
  }
  return drafts;
}

}  // namespace stope
