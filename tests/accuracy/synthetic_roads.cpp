#include "synthetic_roads.hpp"

#include <memory>

#include "stope/stope.hpp"
#include "stope/testing/memory_context.hpp"
#include "stope/testing/memory_ports.hpp"

extern "C" const stope::StageEntry* stope_stage_SyntheticPit();
extern "C" const stope::StageEntry* stope_stage_Voronoi();
extern "C" const stope::StageEntry* stope_stage_Watershed();

namespace stope::testing {
namespace {

std::unique_ptr<StageInstance> make(const StageEntry& entry) {
  std::unique_ptr<StageInstance> instance;
  if (const Outcome made = entry.create(instance); !made) throw Error(made.sentence);
  return instance;
}

std::size_t output_place(const StageInfo& info, std::string_view name) {
  for (std::size_t i = 0; i < info.outputs.size(); ++i) {
    if (info.outputs[i].name == name) return i;
  }
  throw Error("there is no output " + std::string(name));
}

void set(StageInstance& instance, std::string_view name, const ParameterValue& value) {
  const auto& parameters = instance.info().parameters;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    if (parameters[i].name == name) instance.set_parameter(i, value);
  }
}

}  // namespace

SyntheticRoads synthetic_roads(double size, std::uint64_t seed) {
  const auto pit = make(*stope_stage_SyntheticPit());
  set(*pit, "size", size);
  MemoryOutput<OccupancyGrid> grid;
  MemoryOutput<RoadGraph> roads;
  pit->connect_output(output_place(pit->info(), "truth_grid"), &grid);
  pit->connect_output(output_place(pit->info(), "truth_roads"), &roads);
  MemoryContext context(seed);
  if (const Outcome outcome = pit->run(context); !outcome) throw Error(outcome.sentence);
  return {*grid.items.at(0).value, *roads.items.at(0).value};
}

RoadGraph extract_roads(const OccupancyGrid& grid, Extractor extractor) {
  const auto stage =
      make(extractor == Extractor::kVoronoi ? *stope_stage_Voronoi() : *stope_stage_Watershed());
  MemoryContext context;
  const AnyItem input{
      0, 0,
      std::make_shared<MemoryPayload<OccupancyGrid>>(std::make_shared<const OccupancyGrid>(grid))};
  std::shared_ptr<const void> output;
  if (const Outcome outcome = stage->apply(std::span(&input, 1), context, output); !outcome)
    throw Error(outcome.sentence);
  return *static_cast<const RoadGraph*>(output.get());
}

}  // namespace stope::testing
