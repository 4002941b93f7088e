#include "framework/pipeline/export_choice.hpp"

#include <algorithm>
#include <set>

#include "framework/pipeline/port_choice.hpp"
#include "stope/payloads/artefact.hpp"

namespace stope {

const PortInfo* exported_input(const StageInfo& stage) {
  const PortInfo* found = nullptr;
  for (const PortInfo& input : stage.inputs) {
    if (!input.required) continue;
    if (found) return nullptr;
    found = &input;
  }
  return found;
}

bool is_export(const StageInfo& stage) {
  return stage.outputs.size() == 1 && stage.outputs[0].type == Artefact::kType;
}

std::vector<const StageRecord*> exports_writing(const Catalogue& catalogue,
                                                const std::string& extension) {
  std::vector<const StageRecord*> result;
  for (const StageRecord& record : catalogue.stages()) {
    const auto& written = record.info.extensions;
    if (is_export(record.info) &&
        std::find(written.begin(), written.end(), extension) != written.end())
      result.push_back(&record);
  }
  return result;
}

std::vector<const StageRecord*> exports_for(const Catalogue& catalogue,
                                            const std::string& extension, const PortInfo& output) {
  std::vector<const StageRecord*> result = exports_writing(catalogue, extension);
  std::erase_if(result, [&](const StageRecord* record) {
    const PortInfo* input = exported_input(record->info);
    return !input || !same_payload(output, *input);
  });
  return result;
}

std::vector<std::string> written_extensions(const Catalogue& catalogue, const PortInfo* output) {
  std::set<std::string> result;
  for (const StageRecord& record : catalogue.stages()) {
    if (!is_export(record.info)) continue;
    const PortInfo* input = exported_input(record.info);
    if (!output || (input && same_payload(*output, *input)))
      result.insert(record.info.extensions.begin(), record.info.extensions.end());
  }
  return {result.begin(), result.end()};
}

}  // namespace stope
