#include "framework/pipeline/parameters.hpp"

#include <fmt/format.h>

#include "framework/pipeline/codes.hpp"
#include "framework/pipeline/parameter_check.hpp"
#include "framework/pipeline/path_check.hpp"
#include "framework/pipeline/sentence.hpp"

namespace stope {
namespace {

bool is_member_key(const std::string& key) { return key.find('/') != std::string::npos; }

std::vector<std::string> names_of(const StageInfo& info) {
  std::vector<std::string> names;
  for (const ParameterInfo& parameter : info.parameters) names.push_back(parameter.name);
  return names;
}

bool has_parameter(const StageInfo& info, const std::string& name) {
  for (const ParameterInfo& parameter : info.parameters)
    if (parameter.name == name) return true;
  return false;
}

// What is written for one stage, held against its declaration.
class Block {
 public:
  Block(const StageInfo& info, const Catalogue& catalogue, Diagnostics& diagnostics)
      : info_(info), catalogue_(catalogue), diagnostics_(diagnostics) {
    values_.resize(info.parameters.size());
    written_.assign(info.parameters.size(), false);
  }

  // Later entries win.
  void read(const LocatedNode& map) {
    for (const LocatedEntry& entry : map.entries) {
      if (is_member_key(entry.key)) continue;
      bool known = false;
      for (std::size_t i = 0; i < info_.parameters.size(); ++i) {
        if (info_.parameters[i].name != entry.key) continue;
        known = true;
        written_[i] = true;
        values_[i] = check_parameter(info_.parameters[i], entry.value, info_.id, diagnostics_);
      }
      if (!known) report_unknown(entry);
    }
  }

  bool written(std::size_t i) const { return written_[i]; }
  const std::optional<ParameterValue>& value(std::size_t i) const { return values_[i]; }

 private:
  void report_unknown(const LocatedEntry& entry) {
    const std::vector<std::string> names = names_of(info_);
    std::string hint = did_you_mean(entry.key, names);
    if (hint.empty()) {
      std::vector<std::string> owners;
      for (const std::string& id : members_of(catalogue_, family_of(info_.id)))
        if (const StageRecord* member = catalogue_.find(id))
          if (has_parameter(member->info, entry.key)) owners.push_back(id);
      if (!owners.empty())
        hint = fmt::format("{} {} it: write '{}: {{{}: …}}' under params:.", quoted_list(owners),
                           owners.size() == 1 ? "has" : "have", owners[0], entry.key);
    }
    diagnostics_.error(
        code::kUnknownParameter, entry.place,
        fmt::format("{} has no parameter '{}'; it has {}.", info_.id, shown(entry.key),
                    names.empty() ? "none" : quoted_list(names, "and", 12)),
        hint);
  }

  const StageInfo& info_;
  const Catalogue& catalogue_;
  Diagnostics& diagnostics_;
  std::vector<std::optional<ParameterValue>> values_;
  std::vector<bool> written_;
};

void report_unknown_member(const LocatedEntry& entry, const Catalogue& catalogue,
                           Diagnostics& diagnostics) {
  std::vector<std::string> ids;
  for (const StageRecord& record : catalogue.stages()) ids.push_back(record.info.id);
  diagnostics.warning(
      code::kUnknownMember, entry.place,
      fmt::format("These parameters are for '{}', which no plugin offers; they are not checked.",
                  shown(entry.key)),
      did_you_mean(entry.key, ids));
}

ParameterValue default_of(const ParameterInfo& parameter) {
  // Paths travel as absolute text, also those a stage brings along.
  const auto* text = std::get_if<std::string>(&parameter.default_value);
  if (parameter.kind == ParameterKind::kPath && text && !text->empty())
    return absolute_path(*text, "").string();
  return parameter.default_value;
}

}  // namespace

void read_parameters(StageDraft& draft, const Catalogue& catalogue, Diagnostics& diagnostics) {
  const LocatedEntry* own = draft.params ? draft.params->find(draft.use) : nullptr;
  if (draft.params) {
    for (const LocatedEntry& entry : draft.params->entries) {
      if (!is_member_key(entry.key) || entry.value.broken) continue;
      if (!entry.value.is_map() && !entry.value.is_empty()) {
        diagnostics.error(code::kWrongKind, entry.value.place,
                          fmt::format("The parameters of '{}' must be a map; here stands {}.",
                                      shown(entry.key), kind_name(entry.value)),
                          fmt::format("Write '{}: {{name: value}}'.", shown(entry.key)));
        continue;
      }
      const StageRecord* member = catalogue.find(entry.key);
      if (!member) {
        if (entry.key != draft.use) report_unknown_member(entry, catalogue, diagnostics);
      } else if (&entry != own || !draft.record) {
        Block(member->info, catalogue, diagnostics).read(entry.value);
      }
    }
  }
  if (!draft.record) return;
  const StageInfo& info = draft.record->info;
  Block block(info, catalogue, diagnostics);
  if (draft.params) block.read(*draft.params);
  if (own && own->value.is_map()) block.read(own->value);
  for (std::size_t i = 0; i < info.parameters.size(); ++i) {
    const ParameterInfo& parameter = info.parameters[i];
    if (!block.written(i) && parameter.limits.required && !parameter.optional)
      diagnostics.error(
          code::kMissingParameter, draft.place,
          fmt::format("{} needs the parameter '{}'.", draft.subject(), parameter.name),
          joined(parameter.doc, fmt::format("Write 'params: {{{}: …}}'.", parameter.name)));
    draft.parameters.push_back(block.value(i).value_or(default_of(parameter)));
  }
}

}  // namespace stope
