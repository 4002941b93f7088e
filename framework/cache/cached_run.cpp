#include "framework/cache/cached_run.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <optional>
#include <random>
#include <utility>

#include "framework/cache/file_digests.hpp"
#include "framework/cache/input_check.hpp"
#include "framework/cache/store_contents.hpp"
#include "framework/cache/store_folder.hpp"
#include "framework/cache/stored_stage.hpp"
#include "framework/cache/warning_memory.hpp"
#include "framework/plugins/plugin_search.hpp"
#include "framework/plugins/sdk_build.hpp"
#include "stope/error.hpp"

namespace stope {
namespace {

/// An open store.
struct Store {
  explicit Store(const std::filesystem::path& root) : objects(root), stages(root), journal(root) {}
  ObjectStore objects;
  KeptStages stages;
  ItemJournal journal;
};

std::string name_of_this_run() {
  std::random_device device;
  return fmt::format("{:08x}{:08x}{:08x}{:08x}", device(), device(), device(), device());
}

/// `wanted`, and one output of each stage that has some but whose outputs nobody reads.
std::vector<PlannedSource> with_unread_stages(const Plan& plan, std::vector<PlannedSource> wanted) {
  std::vector<bool> read(plan.stages.size(), false);
  for (const PlannedSource& source : wanted) read[source.stage] = true;
  for (const PlannedStage& stage : plan.stages)
    for (const auto& source : stage.inputs)
      if (source) read[source->stage] = true;
  for (std::size_t i = 0; i < plan.stages.size(); ++i)
    if (!read[i] && !plan.stages[i].info.outputs.empty()) wanted.push_back({i, 0});
  return wanted;
}

}  // namespace

struct CachedRun::State {
  const Plan& plan;
  const Catalogue& catalogue;
  std::uint64_t seed;
  CacheUse use;
  RunObserver& observer;
  std::optional<Store> store{};
  std::optional<FileDigests> digests{};
  std::vector<StageKey> keys{};
  Reuse reuse{};
  std::optional<InputCheck> inputs{};  ///< of the latest attempt
  std::string complaint{};

  void complain(const std::string& sentence) {
    if (complaint.empty()) complaint = sentence;
  }

  void open_store() {
    if (use.store.empty()) return;
    try {
      make_store(use.store);
      store.emplace(use.store);
    } catch (const std::exception& error) {
      complain(error.what());
    }
  }

  void make_keys(const std::atomic<bool>* stop) {
    digests.emplace(store ? use.store / "digests" : std::filesystem::path());
    KeyFacts facts;
    facts.seed = seed;
    facts.run = name_of_this_run();
    facts.sdk = sdk_build_id();
    facts.digest_of_path = [&](const std::filesystem::path& path) {
      return digests->of(path, stop);
    };
    keys = stage_keys(plan, catalogue, facts);
    if (store) digests->save();
  }

  Reuse decided(const std::vector<PlannedSource>& wanted, bool take) const {
    if (store && take) {
      Reuse reuse = decide(plan, keys, wanted, store->stages, store->objects);
      find_made_items(plan, keys, store->journal, store->objects, reuse);
      return reuse;
    }
    // Without a store all that is there runs, as it always did.
    Reuse all;
    all.fates.resize(plan.stages.size(), Fate::kRuns);
    all.stored.resize(plan.stages.size());
    return all;
  }

  void tell() const {
    if (!store) return;
    observer.log(LogLevel::kInfo, "", fates_text(reuse));
    for (std::size_t i = 0; i < reuse.made.size(); ++i)
      if (!reuse.made[i].empty())
        observer.log(LogLevel::kInfo, plan.stages[i].name,
                     fmt::format("goes on: {} items were made before", reuse.made[i][0].size()));
  }

  // Of stages whose results are taken, or are in what is taken.
  void repeat_all_warnings() {
    for (std::size_t i = 0; i < plan.stages.size(); ++i) {
      if (is_made(reuse.fates[i]) || keys[i].only_this_run) continue;
      const auto kept =
          reuse.fates[i] == Fate::kStored ? reuse.stored[i] : store->stages.find(keys[i].digest);
      if (kept) repeat_warnings(*kept, plan.stages[i].name, store->objects, observer);
    }
  }

  // Of stages none of whose outputs are kept: the keeper has taken those of the others.
  void note_warnings(WarningMemory& memory) {
    if (use.keep == Keep::kNothing) return;
    try {
      for (std::size_t i = 0; i < plan.stages.size(); ++i) {
        if (reuse.fates[i] != Fate::kRuns || keys[i].only_this_run || !inputs->holds(i)) continue;
        if (auto note = memory.take(plan.stages[i].name, store->objects))
          store->stages.save(keys[i].digest,
                             {KeptStage::kFormat, plan.stages[i].name, {*std::move(note)}});
      }
    } catch (const std::exception& error) {
      complain(error.what());
    }
  }

  void warn_of_damaged_records() const {
    const std::size_t damaged = store ? store->stages.damaged() : 0;
    if (damaged > 0)
      observer.log(LogLevel::kWarning, "",
                   fmt::format("{} in the store {} damaged: what {} told of is computed anew",
                               damaged == 1 ? "a record" : fmt::format("{} records", damaged),
                               damaged == 1 ? "is" : "are", damaged == 1 ? "it" : "they"));
  }

  void warn_of_changed_inputs() const {
    for (const std::filesystem::path& path : inputs->changed())
      observer.log(LogLevel::kWarning, "",
                   fmt::format("{} was changed, replaced or touched while the run went on: the "
                               "results may be made of both the old and the new, and nothing that "
                               "depends on it is kept for other runs. Run again when it is settled",
                               path.string()));
  }

  void tidy_up() {
    if (!store || reuse.count(Fate::kRuns) == 0) return;
    try {
      if (collect_garbage(store->objects, use.limit).removed > 0)
        forget_what_is_gone(store->objects);
    } catch (const std::exception& error) {
      complain(error.what());
    }
  }
};

CachedRun::CachedRun(const Plan& plan, const Catalogue& catalogue, std::uint64_t seed, CacheUse use,
                     RunObserver& observer, const std::atomic<bool>* stop)
    : state_(new State{plan, catalogue, seed, std::move(use), observer}) {
  state_->open_store();
  state_->make_keys(stop);
}

CachedRun::~CachedRun() = default;

const std::vector<StageKey>& CachedRun::keys() const { return state_->keys; }
const Reuse& CachedRun::reuse() const { return state_->reuse; }
std::string CachedRun::complaint() const { return state_->complaint; }

RunRecord CachedRun::run(const std::vector<PlannedSource>& asked,
                         const std::function<std::vector<Sink>(const Reuse&)>& sinks_of,
                         RunOptions options,
                         const std::function<void(const RunProgress&)>& progress) {
  State& state = *state_;
  options.seed = state.seed;
  const std::vector<PlannedSource> wanted = with_unread_stages(state.plan, asked);
  // What is found damaged is removed, so that each attempt takes less from the store.
  for (std::size_t attempt = 0;; ++attempt) {
    state.reuse = state.decided(wanted, state.use.take && attempt <= state.plan.stages.size());
    if (attempt == 0) state.warn_of_damaged_records();
    state.inputs.emplace(state.plan, state.keys, state.reuse.fates, *state.digests);
    state.tell();
    std::vector<Sink> sinks = sinks_of(state.reuse);
    if (!state.store) {
      RunRecord record =
          run_plan(state.plan, state.catalogue, sinks, options, state.observer, progress);
      state.warn_of_changed_inputs();
      return record;
    }
    std::vector<PlannedSource> read = wanted;
    for (const Sink& sink : sinks) read.push_back(sink.source);
    WarningMemory memory(state.observer);
    Keeper keeper(state.plan, state.keys, state.reuse, read, state.use.keep, *state.inputs,
                  state.store->stages, state.store->objects, &state.store->journal, &memory);
    std::vector<Sink> all = keeper.sinks();
    all.insert(all.end(), sinks.begin(), sinks.end());
    const Plan plan = with_reuse(state.plan, state.reuse);
    const ReusingCatalogue catalogue(state.plan, state.reuse, state.catalogue,
                                     state.store->objects);
    if (state.use.take) state.repeat_all_warnings();
    RunRecord record = run_plan(plan, catalogue, all, options, memory, progress);
    keeper.end();
    if (const std::string complaint = keeper.complaint(); !complaint.empty())
      state.complain(complaint);
    if (record.end == RunRecord::End::kFailed && catalogue.damaged()) {
      state.observer.log(
          LogLevel::kWarning, record.failed_stage,
          "what the store had of this stage was damaged or removed: the run begins again, "
          "and computes it anew");
      continue;
    }
    if (record.end == RunRecord::End::kDone) state.note_warnings(memory);
    state.warn_of_changed_inputs();
    state.tidy_up();
    return record;
  }
}

bool CachedRun::inputs_hold(std::size_t stage) const {
  return !state_->inputs || state_->inputs->holds(stage);
}

void CachedRun::note(std::size_t stage, const std::string& name,
                     const std::function<void(ByteSink&)>& write) {
  State& state = *state_;
  if (!state.store || state.use.keep == Keep::kNothing || state.keys[stage].only_this_run) return;
  if (!inputs_hold(stage)) return;
  try {
    const StoredObject object = state.store->objects.put(write);
    KeptStage kept;
    kept.name = state.plan.stages[stage].name;
    kept.outputs = {{name, std::string(kNoteType), 0, false, {{0, 0, object.digest, object.size}}}};
    state.store->stages.save(state.keys[stage].digest, kept);
  } catch (const std::exception& error) {
    state.complain(error.what());
  }
}

bool CachedRun::noted(std::size_t stage, const std::string& name,
                      const std::function<void(ByteSource&)>& read) {
  State& state = *state_;
  if (!state.store || !state.use.take) return false;
  const auto kept = state.store->stages.find(state.keys[stage].digest);
  if (!kept) return false;
  for (const KeptOutput& output : kept->outputs)
    if (output.port == name && output.type == kNoteType && output.items.size() == 1)
      return state.store->objects.get(output.items[0].object, read);
  return false;
}

std::filesystem::path default_store() {
  if (const auto named = process_environment()("STOPE_CACHE"); named && !named->empty())
    return *named;
  const auto manifests = manifest_folder();
  return manifests ? manifests->parent_path() / "store" : std::filesystem::path();
}

}  // namespace stope
