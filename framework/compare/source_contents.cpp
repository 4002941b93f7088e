#include "framework/compare/source_contents.hpp"

#include <algorithm>

#include "stope/digest.hpp"

namespace stope {
namespace {

/// Whether all that is read of a source is in the store, as values of its own.
bool holds_values(const KeptStage& stage, const std::vector<PortInfo>& read) {
  return std::all_of(read.begin(), read.end(), [&](const PortInfo& port) {
    const KeptOutput* output = stage.find(port);
    return !port.stream && output && !output->lazy && !output->items.empty();
  });
}

}  // namespace

CellSources sources_of(const Plan& plan, const std::vector<StageKey>& keys) {
  CellSources cell;
  for (std::size_t i = 0; i < plan.stages.size(); ++i) {
    const PlannedStage& stage = plan.stages[i];
    if (std::any_of(stage.inputs.begin(), stage.inputs.end(),
                    [](const auto& input) { return input.has_value(); }))
      continue;
    if (keys[i].only_this_run) return {};
    CellSources::Source source{keys[i].digest, stage.info.id, {}};
    for (std::size_t port = 0; port < stage.info.outputs.size(); ++port) {
      const PlannedSource here{i, port};
      const bool is_read =
          std::any_of(plan.stages.begin(), plan.stages.end(), [&](const PlannedStage& reader) {
            return std::find(reader.inputs.begin(), reader.inputs.end(), here) !=
                   reader.inputs.end();
          });
      if (is_read) source.read.push_back(stage.info.outputs[port]);
    }
    cell.sources.push_back(std::move(source));
  }
  cell.unknown = false;
  return cell;
}

std::string contents_key(const CellSources& cell, const KeptStages* kept) {
  if (cell.unknown) return {};
  Digester digester;
  for (const CellSources::Source& source : cell.sources) {
    encode(source.use, digester);
    const auto stage = kept ? kept->find(source.key) : std::nullopt;
    if (!stage || source.read.empty() || !holds_values(*stage, source.read)) {
      encode(source.key.text(), digester);
      continue;
    }
    for (const PortInfo& port : source.read) {
      encode(port.name, digester);
      for (const KeptItem& item : stage->find(port)->items) {
        encode(item.stamp, digester);
        encode(item.object.text(), digester);
      }
    }
  }
  return digester.digest().text();
}

}  // namespace stope
