// Problem: arms that differ late share most of their work, and a cold comparison must do it once.
// Idea: stages with equal keys give equal bytes, so one of them can stand for all. Take the plans
// one after the other, each in topological order; a stage whose key was seen becomes the one seen,
// any other is added with its inputs, which are there already. Cost: linear in the stages.
#include "framework/compare/merge_plans.hpp"

#include <fmt/format.h>

#include <map>
#include <utility>

namespace stope {
namespace {

constexpr std::size_t kMostNames = 3;

std::string with_owners(const std::string& name, const std::vector<std::size_t>& owners,
                        const std::vector<PlanToMerge>& arms) {
  std::string list;
  for (std::size_t i = 0; i < owners.size() && i < kMostNames; ++i)
    list += fmt::format("{}{}", i == 0 ? "" : ", ", arms[owners[i]].name);
  if (owners.size() > kMostNames) list += fmt::format(" and {} more", owners.size() - kMostNames);
  return fmt::format("{} ({})", name, list);
}

// Two lists of owners may look the same when cut.
void name_apart(MergedPlan& merged, const std::vector<PlanToMerge>& arms) {
  std::map<std::string, std::size_t> of_name, used;
  for (const PlannedStage& stage : merged.plan.stages) ++of_name[stage.name];
  for (std::size_t i = 0; i < merged.plan.stages.size(); ++i) {
    PlannedStage& stage = merged.plan.stages[i];
    if (of_name[stage.name] == 1) continue;
    stage.seeded_as = stage.seed_name();
    stage.name = with_owners(stage.name, merged.owners[i], arms);
    if (const std::size_t before = used[stage.name]++; before > 0)
      stage.name += fmt::format(" #{}", before + 1);
  }
}

}  // namespace

MergedPlan merge_plans(const std::vector<PlanToMerge>& arms) {
  MergedPlan merged;
  std::map<Digest, std::size_t> place_of;
  for (std::size_t arm = 0; arm < arms.size(); ++arm) {
    const Plan& plan = *arms[arm].plan;
    std::vector<std::size_t>& places = merged.places.emplace_back();
    for (std::size_t i = 0; i < plan.stages.size(); ++i) {
      const auto [place, fresh] =
          place_of.emplace((*arms[arm].keys)[i].digest, merged.plan.stages.size());
      if (fresh) {
        PlannedStage stage = plan.stages[i];
        for (auto& input : stage.inputs)
          if (input) input->stage = places[input->stage];
        merged.plan.stages.push_back(std::move(stage));
        merged.owners.emplace_back();
      }
      places.push_back(place->second);
      merged.owners[place->second].push_back(arm);
    }
  }
  if (!arms.empty()) {
    merged.plan.name = arms[0].plan->name;
    merged.plan.file = arms[0].plan->file;
  }
  name_apart(merged, arms);
  return merged;
}

MergedPlan without_arms(const MergedPlan& merged, const std::set<std::size_t>& arms) {
  MergedPlan rest;
  rest.plan.name = merged.plan.name;
  rest.plan.file = merged.plan.file;
  std::vector<std::size_t> now(merged.plan.stages.size());
  for (std::size_t i = 0; i < merged.plan.stages.size(); ++i) {
    std::vector<std::size_t> owners = merged.owners[i];
    std::erase_if(owners, [&](std::size_t arm) { return arms.contains(arm); });
    if (owners.empty()) continue;
    now[i] = rest.plan.stages.size();
    PlannedStage stage = merged.plan.stages[i];
    for (auto& input : stage.inputs)
      if (input) input->stage = now[input->stage];
    rest.plan.stages.push_back(std::move(stage));
    rest.owners.push_back(std::move(owners));
  }
  rest.places = merged.places;
  for (auto& places : rest.places)
    for (std::size_t& place : places) place = now[place];
  return rest;
}

}  // namespace stope
