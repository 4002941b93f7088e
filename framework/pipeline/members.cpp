#include "framework/pipeline/members.hpp"

#include <algorithm>
#include <tuple>

#include "framework/pipeline/port_choice.hpp"

namespace stope {
namespace {

using Shape = std::vector<std::tuple<std::string, std::string, std::uint64_t>>;

Shape required_inputs(const StageInfo& info) {
  Shape shape;
  for (const PortInfo& port : info.inputs)
    if (port.required) shape.emplace_back(port.name, port.type, port.layout);
  std::sort(shape.begin(), shape.end());
  return shape;
}

// A stage with one output may call it what it likes; several are told apart by their names.
bool gives_all_of(const StageInfo& other, const StageInfo& stage) {
  const bool by_type = other.outputs.size() == 1 && stage.outputs.size() == 1;
  return std::all_of(stage.outputs.begin(), stage.outputs.end(), [&](const PortInfo& wanted) {
    return std::any_of(other.outputs.begin(), other.outputs.end(), [&](const PortInfo& port) {
      return same_payload(port, wanted) && (by_type || port.name == wanted.name);
    });
  });
}

bool takes_wires(const StageInfo& candidate, const std::vector<StageDraft>& drafts,
                 const StageDraft& stage) {
  std::vector<bool> wired(candidate.inputs.size(), false);
  for (const Wire& wire : stage.wires) {
    const auto input = choose_input(candidate, wire.input);
    if (!input) return false;
    wired[*input] = true;
    if (!wire.producer || !drafts[*wire.producer].record) continue;
    const StageInfo& producer = drafts[*wire.producer].record->info;
    const OutputChoice output = choose_output(producer, wire.port, &candidate.inputs[*input]);
    if (!output.port) {
      // A wire from a port that is not there says nothing about this end.
      if (output.ambiguous) return false;
      continue;
    }
    if (!same_payload(producer.outputs[*output.port], candidate.inputs[*input])) return false;
  }
  for (std::size_t i = 0; i < wired.size(); ++i)
    if (candidate.inputs[i].required && !wired[i]) return false;
  return true;
}

bool gives_wires(const StageInfo& candidate, const std::vector<StageDraft>& drafts,
                 std::size_t stage) {
  for (const StageDraft& reader : drafts) {
    for (const Wire& wire : reader.wires) {
      if (wire.producer != stage || !reader.record) continue;
      const auto input = choose_input(reader.record->info, wire.input);
      if (!input) continue;
      const PortInfo& to = reader.record->info.inputs[*input];
      const OutputChoice output = choose_output(candidate, wire.port, &to);
      if (!output.port || !same_payload(candidate.outputs[*output.port], to)) return false;
    }
  }
  return true;
}

}  // namespace

std::vector<std::string> interchangeable_members(const Catalogue& catalogue, std::string_view id) {
  const StageRecord* stage = catalogue.find(id);
  if (!stage) return {};
  std::vector<std::string> ids;
  for (const StageRecord& other : catalogue.stages())
    if (family_of(other.info.id) == family_of(stage->info.id) &&
        required_inputs(other.info) == required_inputs(stage->info) &&
        gives_all_of(other.info, stage->info) &&
        // A source's parameters say where its data lies; one that gives more reads something else.
        (!required_inputs(stage->info).empty() || gives_all_of(stage->info, other.info)))
      ids.push_back(other.info.id);
  return ids;
}

std::vector<std::string> members_that_fit(const std::vector<StageDraft>& drafts, std::size_t stage,
                                          const Catalogue& catalogue) {
  const StageDraft& draft = drafts[stage];
  std::vector<std::string> ids;
  if (draft.wires_broken) return ids;
  for (const StageRecord& record : catalogue.stages())
    if (record.info.id != draft.use && family_of(record.info.id) == family_of(draft.use) &&
        takes_wires(record.info, drafts, draft) && gives_wires(record.info, drafts, stage))
      ids.push_back(record.info.id);
  return ids;
}

}  // namespace stope
