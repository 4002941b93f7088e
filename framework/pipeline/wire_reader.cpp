#include "framework/pipeline/wire_reader.hpp"

#include <fmt/format.h>

#include "framework/pipeline/codes.hpp"
#include "framework/pipeline/sentence.hpp"

namespace stope {

std::optional<Wire> read_wire(const LocatedNode& node, Diagnostics& diagnostics) {
  if (node.broken) return std::nullopt;
  const auto refuse = [&](const char* code, const std::string& what) {
    diagnostics.error(code, node.place,
                      fmt::format("A stage or one of its outputs must be named here, as 'stage' or "
                                  "'stage.port'; here stands {}.",
                                  what));
    return std::nullopt;
  };
  if (node.is_empty()) return refuse(code::kNoValue, "nothing");
  if (!node.is_scalar()) return refuse(code::kWrongKind, kind_name(node));
  const auto dot = node.text.find('.');
  Wire wire;
  wire.place = node.place;
  wire.stage = node.text.substr(0, dot);
  if (dot != std::string::npos) wire.port = node.text.substr(dot + 1);
  const bool two_dots = wire.port.find('.') != std::string::npos;
  const bool spaced = node.text.find_first_of(" \t\n,") != std::string::npos;
  if (wire.stage.empty() || (dot != std::string::npos && wire.port.empty()) || two_dots || spaced)
    return refuse(code::kMalformedWire, fmt::format("'{}'", shown(node.text)));
  return wire;
}

void read_wires(StageDraft& draft, const LocatedNode& in, Diagnostics& diagnostics) {
  if (in.broken) {
    draft.wires_broken = true;
  } else if (in.is_map()) {
    for (const LocatedEntry& entry : in.entries) {
      std::optional<Wire> wire = read_wire(entry.value, diagnostics);
      if (!wire) {
        // The input is wired, only to what is not known; it is not missing.
        wire.emplace();
        wire->place = entry.value.place;
      }
      wire->input = entry.key;
      wire->input_place = entry.place;
      draft.wires.push_back(std::move(*wire));
    }
  } else if (in.is_scalar()) {
    if (std::optional<Wire> wire = read_wire(in, diagnostics)) {
      wire->input_place = wire->place;
      draft.wires.push_back(std::move(*wire));
    } else {
      draft.wires_broken = true;
    }
  } else {
    draft.wires_broken = true;
    diagnostics.error(in.is_empty() ? code::kNoValue : code::kWrongKind, in.place,
                      fmt::format("'in' must say what {} reads; here stands {}.",
                                  draft.is_export ? "the output" : "the stage", kind_name(in)),
                      "Write 'in: stage', or 'in: {input: stage.port}' for several inputs.");
  }
}

void find_producers(std::vector<StageDraft>& drafts, StageDraft& reader, Diagnostics& diagnostics) {
  for (Wire& wire : reader.wires) {
    if (wire.stage.empty()) continue;
    std::vector<std::string> names;
    for (std::size_t i = 0; i < drafts.size(); ++i) {
      if (drafts[i].is_export) continue;
      if (drafts[i].name == wire.stage) wire.producer = i;
      names.push_back(drafts[i].name);
    }
    if (wire.producer) {
      drafts[*wire.producer].read = true;
      continue;
    }
    std::string hint;
    for (const StageDraft& draft : drafts)
      if (!draft.is_export && draft.use == wire.stage && hint.empty())
        hint = fmt::format("Stages are named as the pipeline calls them: '{}'.", draft.name);
    if (hint.empty())
      hint = did_you_mean(wire.stage, names,
                          names.empty() ? "" : fmt::format("It has {}.", quoted_list(names)));
    diagnostics.error(code::kWireFromUnknownStage, wire.place,
                      fmt::format("The pipeline has no stage '{}'.", shown(wire.stage)), hint);
  }
}

}  // namespace stope
