#include "framework/report/tap_choice.hpp"

#include <set>
#include <utility>

#include "framework/report/draw/sketch_table.hpp"
#include "stope/payloads/measures.hpp"

namespace stope::report {
namespace {

using Port = std::pair<std::size_t, std::size_t>;

// Ports that some stage reads, and those an export reads.
void find_readers(const Plan& plan, std::set<Port>& read, std::set<Port>& exported) {
  for (const PlannedStage& stage : plan.stages) {
    for (const auto& input : stage.inputs) {
      if (!input) continue;
      read.emplace(input->stage, input->port);
      if (stage.is_export) exported.emplace(input->stage, input->port);
    }
  }
}

}  // namespace

std::vector<TapChoice> choose_taps(const Plan& plan) {
  std::set<Port> read, exported;
  find_readers(plan, read, exported);
  std::vector<TapChoice> taps;
  for (std::size_t s = 0; s < plan.stages.size(); ++s) {
    const PlannedStage& stage = plan.stages[s];
    bool any_read = false;
    for (std::size_t p = 0; p < stage.info.outputs.size(); ++p) any_read |= read.contains({s, p});
    for (std::size_t p = 0; p < stage.info.outputs.size(); ++p) {
      const std::string& type = stage.info.outputs[p].type;
      TapChoice tap{{s, p}, exported.contains({s, p}), {}, !any_read || type == Measures::kType};
      if (read.contains({s, p}) || !any_read || type == Measures::kType)
        tap.draw = sketch_function(type);
      tap.needed = tap.needed && tap.draw;
      if (tap.digest || tap.draw) taps.push_back(std::move(tap));
    }
  }
  return taps;
}

}  // namespace stope::report
