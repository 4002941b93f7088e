#include "framework/cache/reuse.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace stope {
namespace {

class Decision {
 public:
  Decision(const Plan& plan, const std::vector<PlannedSource>& wanted) : plan_(plan) {
    for (const PlannedStage& stage : plan.stages)
      asked_.emplace_back(stage.info.outputs.size(), false);
    for (const PlannedSource& source : wanted) asked_[source.stage][source.port] = true;
  }

  Reuse decide(const std::vector<StageKey>& keys, const KeptStages& kept,
               const ObjectStore& store) {
    Reuse reuse;
    reuse.fates.resize(plan_.stages.size(), Fate::kNotNeeded);
    reuse.stored.resize(plan_.stages.size());
    // Inputs come from earlier stages, so going backwards everybody has been asked in time.
    for (std::size_t stage = plan_.stages.size(); stage-- > 0;) {
      const bool asked =
          std::find(asked_[stage].begin(), asked_[stage].end(), true) != asked_[stage].end();
      if (!asked && !asked_[stage].empty()) continue;
      auto found =
          keys[stage].only_this_run || !asked ? std::nullopt : kept.find(keys[stage].digest);
      if (found && whole(stage, *found, store)) {
        reuse.fates[stage] = is_lazy(stage, *found) ? Fate::kReopened : Fate::kStored;
        reuse.stored[stage] = *std::move(found);
        continue;
      }
      reuse.fates[stage] = Fate::kRuns;
      for (const auto& source : plan_.stages[stage].inputs)
        if (source) asked_[source->stage][source->port] = true;
    }
    return reuse;
  }

 private:
  bool whole(std::size_t stage, const KeptStage& found, const ObjectStore& store) const {
    for (std::size_t port = 0; port < asked_[stage].size(); ++port) {
      if (!asked_[stage][port]) continue;
      const KeptOutput* output = found.find(plan_.stages[stage].info.outputs[port]);
      const auto there = [&](const KeptItem& item) { return store.contains(item.object); };
      if (!output || !std::all_of(output->items.begin(), output->items.end(), there)) return false;
    }
    return true;
  }

  bool is_lazy(std::size_t stage, const KeptStage& found) const {
    for (std::size_t port = 0; port < asked_[stage].size(); ++port)
      if (asked_[stage][port] && found.find(plan_.stages[stage].info.outputs[port])->lazy)
        return true;
    return false;
  }

  const Plan& plan_;
  std::vector<std::vector<bool>> asked_;  ///< by stage and port
};

}  // namespace

std::size_t Reuse::count(Fate fate) const {
  return static_cast<std::size_t>(std::count(fates.begin(), fates.end(), fate));
}

std::string fates_text(const Reuse& reuse) {
  const std::size_t runs = reuse.count(Fate::kRuns), reopened = reuse.count(Fate::kReopened),
                    stored = reuse.count(Fate::kStored), rest = reuse.count(Fate::kNotNeeded);
  std::string text = runs == 1 ? "1 stage runs" : fmt::format("{} stages run", runs);
  if (reopened > 0)
    text += fmt::format(", {} {} reopened", reopened, reopened == 1 ? "source is" : "sources are");
  if (stored > 0)
    text += fmt::format(", {} {} from the store", stored, stored == 1 ? "comes" : "come");
  if (rest > 0) text += fmt::format(", {} {} not needed", rest, rest == 1 ? "is" : "are");
  return text;
}

Reuse decide(const Plan& plan, const std::vector<StageKey>& keys,
             const std::vector<PlannedSource>& wanted, const KeptStages& kept,
             const ObjectStore& store) {
  return Decision(plan, wanted).decide(keys, kept, store);
}

void find_made_items(const Plan& plan, const std::vector<StageKey>& keys,
                     const ItemJournal& journal, const ObjectStore& store, Reuse& reuse) {
  reuse.made.assign(plan.stages.size(), {});
  for (std::size_t i = 0; i < plan.stages.size(); ++i) {
    const PlannedStage& stage = plan.stages[i];
    if (reuse.fates[i] != Fate::kRuns || !stage.info.map || keys[i].only_this_run) continue;
    MadeItems made;
    for (const PortInfo& port : stage.info.outputs) {
      auto items = journal.items(keys[i].digest, port.name);
      std::erase_if(items, [&](const auto& item) { return !store.contains(item.second.object); });
      if (items.empty()) break;
      made.push_back(std::move(items));
    }
    if (made.size() == stage.info.outputs.size()) reuse.made[i] = std::move(made);
  }
}

}  // namespace stope
