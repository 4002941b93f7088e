#include "framework/pipeline/outputs.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "framework/pipeline/codes.hpp"
#include "framework/pipeline/export_choice.hpp"
#include "framework/pipeline/members.hpp"
#include "framework/pipeline/output_name.hpp"
#include "framework/pipeline/port_choice.hpp"
#include "framework/pipeline/sentence.hpp"
#include "framework/pipeline/wire_reader.hpp"
#include "framework/pipeline/wiring.hpp"

namespace stope {
namespace {

std::string dotted(const std::vector<std::string>& extensions) {
  std::vector<std::string> names;
  for (const std::string& extension : extensions) names.push_back("." + extension);
  return quoted_list(names, "or", 20);
}

class OutputReader {
 public:
  OutputReader(const LocatedEntry& entry, std::vector<StageDraft>& drafts,
               const Catalogue& catalogue, Diagnostics& diagnostics)
      : entry_(entry), drafts_(drafts), catalogue_(catalogue), diagnostics_(diagnostics) {
    draft_.name = entry.key;
    draft_.place = entry.place;
    draft_.is_export = true;
  }

  std::optional<OutputDraft> read() {
    const bool named = check_output_name(entry_.key, entry_.place, diagnostics_);
    if (named) extensions_ = extensions_of(entry_.key);
    const LocatedNode& node = entry_.value;
    if (node.broken) return std::nullopt;
    if (node.is_map()) {
      read_body(draft_, node, catalogue_, diagnostics_);
    } else if (std::optional<Wire> wire = read_wire(node, diagnostics_)) {
      draft_.wires.push_back(*wire);
    } else {
      return std::nullopt;
    }
    find_producers(drafts_, draft_, diagnostics_);
    const bool found =
        draft_.use_place.line != 0 || !draft_.use.empty() ? check_named_export() : choose_export();
    if (!found) return std::nullopt;
    OutputDraft output{entry_.key, stem_of(entry_.key, extension_), drafts_.size(), entry_.place};
    drafts_.push_back(std::move(draft_));
    connect(drafts_, output.draft, catalogue_, diagnostics_);
    return named ? std::optional(output) : std::nullopt;
  }

 private:
  bool check_named_export() {
    if (!draft_.record) return false;
    const StageInfo& info = draft_.record->info;
    if (!is_export(info)) {
      diagnostics_.error(
          code::kNotAnExport, draft_.use_place,
          fmt::format("{} is not an export: it gives no artefact to write.", draft_.use),
          extensions_.empty() ? "" : suggestion(nullptr));
      return false;
    }
    for (const std::string& extension : extensions_) {
      if (std::find(info.extensions.begin(), info.extensions.end(), extension) ==
          info.extensions.end())
        continue;
      extension_ = extension;
      return true;
    }
    if (!extensions_.empty())
      diagnostics_.error(code::kNoExport, entry_.place,
                         fmt::format("{} does not write '.{}'; it writes {}.", draft_.use,
                                     extensions_.back(), dotted(info.extensions)),
                         near_extension(info.extensions));
    // Its wires are worth checking all the same.
    return true;
  }

  // The short form, and the long one without `use`.
  bool choose_export() {
    if (draft_.wires.empty() || draft_.wires_broken) {
      if (!draft_.wires_broken)
        diagnostics_.error(code::kMissingKey, entry_.value.place,
                           fmt::format("{} does not say what to write.", draft_.subject()),
                           "Add 'in: stage'.");
      return false;
    }
    if (draft_.wires.size() > 1 || !draft_.wires[0].input.empty()) {
      diagnostics_.error(
          code::kMissingKey, entry_.value.place,
          fmt::format("{} names inputs, so it must say whose they are.", draft_.subject()),
          "Add 'use: export/name'.");
      return false;
    }
    Wire& wire = draft_.wires[0];
    if (!wire.producer || !drafts_[*wire.producer].record || extensions_.empty()) return false;
    const StageDraft& producer = drafts_[*wire.producer];
    const std::vector<const PortInfo*> candidates = candidate_outputs(wire, producer);
    if (candidates.empty()) return false;
    for (const std::string& extension : extensions_) {
      std::vector<const PortInfo*> writable;
      for (const PortInfo* output : candidates)
        if (!exports_for(catalogue_, extension, *output).empty()) writable.push_back(output);
      if (writable.empty()) continue;
      if (writable.size() > 1) return report_several_outputs(wire, producer, writable, extension);
      const auto exports = exports_for(catalogue_, extension, *writable[0]);
      if (exports.size() > 1) return report_several_exports(*writable[0], exports, extension);
      draft_.record = exports[0];
      draft_.use = exports[0]->info.id;
      draft_.inputs.resize(draft_.record->info.inputs.size());
      draft_.input_places.resize(draft_.record->info.inputs.size());
      wire.input = exported_input(draft_.record->info)->name;
      wire.port = writable[0]->name;
      extension_ = extension;
      return true;
    }
    return report_unwritable(wire, producer, candidates);
  }

  std::vector<const PortInfo*> candidate_outputs(const Wire& wire, const StageDraft& producer) {
    std::vector<const PortInfo*> found;
    std::vector<std::string> names;
    for (const PortInfo& output : producer.record->info.outputs) {
      names.push_back(output.name);
      if (wire.port.empty() || wire.port == output.name) found.push_back(&output);
    }
    if (found.empty())
      diagnostics_.error(code::kUnknownOutputPort, wire.place,
                         fmt::format("{} has no output{}; it has {}.", producer.subject(),
                                     wire.port.empty() ? "" : fmt::format(" '{}'", wire.port),
                                     names.empty() ? "none" : quoted_list(names)),
                         joined(did_you_mean(wire.port, names), members_with_port(wire)));
    return found;
  }

  std::string members_with_port(const Wire& wire) const {
    std::vector<std::string> ids = members_that_fit(drafts_, *wire.producer, catalogue_);
    std::erase_if(ids, [&](const std::string& id) {
      return !choose_output(catalogue_.find(id)->info, wire.port, nullptr).port;
    });
    if (ids.empty()) return "";
    return fmt::format("{} {} it.", quoted_list(ids), ids.size() == 1 ? "has" : "have");
  }

  bool report_several_outputs(const Wire& wire, const StageDraft& producer,
                              const std::vector<const PortInfo*>& outputs,
                              const std::string& extension) {
    std::vector<std::string> names;
    for (const PortInfo* output : outputs) names.push_back(producer.name + "." + output->name);
    diagnostics_.error(code::kAmbiguousOutput, wire.place,
                       fmt::format("{} has {} outputs that can be written as '.{}'.",
                                   producer.subject(), outputs.size(), extension),
                       fmt::format("Write one of {}.", quoted_list(names, "or")));
    return false;
  }

  bool report_several_exports(const PortInfo& output,
                              const std::vector<const StageRecord*>& exports,
                              const std::string& extension) {
    std::vector<std::string> ids;
    for (const StageRecord* record : exports) ids.push_back(record->info.id);
    diagnostics_.error(
        code::kAmbiguousExport, entry_.place,
        fmt::format("{} all write {} as '.{}'.", quoted_list(ids), output.type, extension),
        fmt::format("Choose one: '{}: {{use: {}, in: {}}}'.", entry_.key, ids[0],
                    entry_.value.is_scalar() ? shown(entry_.value.text) : "…"));
    return false;
  }

  bool report_unwritable(const Wire& wire, const StageDraft& producer,
                         const std::vector<const PortInfo*>& candidates) {
    const std::string& extension = extensions_.back();
    const auto writing = exports_writing(catalogue_, extension);
    const PortInfo* output = candidates.size() == 1 ? candidates[0] : nullptr;
    if (writing.empty()) {
      diagnostics_.error(code::kNoExport, entry_.place,
                         fmt::format("No export writes '.{}'.", shown(extension)),
                         suggestion(output));
      return false;
    }
    std::string types;
    for (const StageRecord* record : writing)
      if (const PortInfo* input = exported_input(record->info))
        types.append(
            fmt::format("{}{} ({})", types.empty() ? "" : " or ", input->type, record->info.id));
    const std::string of =
        output ? fmt::format("'{}.{}' ({})", producer.name, output->name, output->type)
               : fmt::format("any output of '{}'", producer.name);
    diagnostics_.error(
        code::kExportType, wire.place,
        fmt::format("No export writes {} as '.{}'; that format is for {}.", of, extension, types),
        output ? suggestion(output) : "");
    return false;
  }

  std::string near_extension(const std::vector<std::string>& known) const {
    const std::string nearest = nearest_name(extensions_.back(), known);
    return nearest.empty() ? "" : fmt::format("Did you mean '.{}'?", nearest);
  }

  std::string suggestion(const PortInfo* output) const {
    const std::vector<std::string> known = written_extensions(catalogue_, output);
    if (const std::string near = near_extension(known); !near.empty()) return near;
    if (known.empty())
      return output ? fmt::format("No export takes {}.", output->type) : "There are no exports.";
    return output ? fmt::format("{} can be written as {}.", output->type, dotted(known))
                  : fmt::format("Exports write {}.", dotted(known));
  }

  const LocatedEntry& entry_;
  std::vector<StageDraft>& drafts_;
  const Catalogue& catalogue_;
  Diagnostics& diagnostics_;
  StageDraft draft_;
  std::vector<std::string> extensions_;
  std::string extension_;
};

}  // namespace

std::vector<OutputDraft> draft_outputs(const LocatedNode* outputs, std::vector<StageDraft>& drafts,
                                       const Catalogue& catalogue, Diagnostics& diagnostics) {
  std::vector<OutputDraft> result;
  if (!outputs) return result;
  for (const LocatedEntry& entry : outputs->entries)
    if (auto output = OutputReader(entry, drafts, catalogue, diagnostics).read())
      result.push_back(std::move(*output));
  return result;
}

}  // namespace stope
