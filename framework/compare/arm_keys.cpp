#include "framework/compare/arm_keys.hpp"

#include "framework/cache/file_digests.hpp"
#include "framework/cache/store_folder.hpp"
#include "framework/plugins/sdk_build.hpp"
#include "stope/digest.hpp"

namespace stope {

std::vector<StageKey> arm_keys(const CompareJob& job, const Plan& plan, std::uint64_t seed,
                               const std::string& run) {
  const std::filesystem::path& store = job.options.cache.store;
  // What is no store is left alone.
  const bool is_there = !store.empty() && is_store(store);
  FileDigests digests(is_there ? store / "digests" : std::filesystem::path());
  KeyFacts facts;
  facts.seed = seed;
  facts.run = run;
  facts.sdk = sdk_build_id();
  facts.digest_of_path = [&](const std::filesystem::path& path) {
    return digests.of(path, job.options.stop);
  };
  std::vector<StageKey> keys = stage_keys(plan, job.catalogue, facts);
  if (is_there) digests.save();
  return keys;
}

std::string cell_key(const Experiment& experiment, const PlannedArm& arm,
                     const std::vector<StageKey>& keys) {
  Digester digester;
  const auto add = [&](const std::string& name, const PlannedSource& source) {
    encode(name, digester);
    encode(keys[source.stage].digest.text(), digester);
    encode(static_cast<std::uint64_t>(source.port), digester);
  };
  for (const PlannedOutput& output : arm.plan->outputs) add(output.name, {output.stage, 0});
  for (std::size_t i = 0; i < experiment.metrics.size(); ++i) {
    add(experiment.metrics[i].name, arm.metrics[i]);
    encode(experiment.metrics[i].measure, digester);
  }
  return digester.digest().text();
}

}  // namespace stope
