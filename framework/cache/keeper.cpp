#include "framework/cache/keeper.hpp"

#include <fmt/format.h>

#include <atomic>
#include <chrono>
#include <mutex>
#include <set>
#include <utility>

#include "framework/executor/run_payload.hpp"
#include "framework/report/run_report.hpp"
#include "stope/error.hpp"
#include "stope/payloads/measures.hpp"

namespace stope {
namespace {

using Clock = std::chrono::steady_clock;

/// Of a run's time at most so much goes into looking at its input files after each item.
constexpr int kShareOfLooking = 20;  // a twentieth

/// One output that is being kept. Its sink alone writes it.
struct Recording {
  PlannedSource source;
  std::size_t stage = 0;  ///< place in State::stages
  KeptOutput output;
  bool is_source = false;
  std::uint64_t items = 0;
  std::vector<KeptItem> unnoted;  ///< of a map, and not in the journal yet
  bool failed = false;
};

struct StageRecording {
  Digest key;
  std::size_t open = 0;  ///< outputs that have not ended
  KeptStage kept;
};

/// What a run is made for: small beside what it was made of, also as a stream.
bool is_result(const PlannedStage& stage, std::size_t port) {
  return stage.is_export || stage.info.outputs[port].type == Measures::kType;
}

}  // namespace

struct Keeper::State {
  const Plan& plan;
  const InputCheck& inputs;
  KeptStages& kept;
  ObjectStore& store;
  ItemJournal* journal;     ///< or null
  WarningMemory* warnings;  ///< or null
  std::vector<Recording> recordings;
  std::vector<StageRecording> stages;
  mutable std::mutex mutex;  ///< of stages and complaint
  std::string complaint;
  Clock::time_point begin = Clock::now();
  std::atomic<Clock::duration> looking = Clock::duration::zero();

  void fail(Recording& recording, const std::exception& error) {
    recording.failed = true;
    const std::lock_guard lock(mutex);
    if (complaint.empty()) complaint = error.what();
  }

  void take(Recording& recording, const AnyItem& item) {
    if (recording.failed) return;
    // What a source loads from its own files is at hand already.
    const auto* payload = dynamic_cast<const RunPayload*>(item.payload.get());
    const bool lazy = recording.is_source && payload && payload->lazy();
    if (recording.items++ == 0) recording.output.lazy = lazy;
    if (recording.output.lazy != lazy) recording.failed = true;
    if (lazy || recording.failed) return;
    try {
      const auto value = item.payload->pin();
      const StoredObject object =
          store.put([&](ByteSink& sink) { item.payload->type().encode(value.get(), sink); });
      recording.output.items.push_back({item.stamp, item.index, object.digest, object.size});
      if (!journal || !is_resumable(recording)) return;
      recording.unnoted.push_back(recording.output.items.back());
      // A recording may be thousands of files: items wait until it is worth a look at them all.
      if (looking.load() * kShareOfLooking <= Clock::now() - begin) note_items(recording);
    } catch (const Cancelled&) {
      throw;
    } catch (const std::exception& error) {
      fail(recording, error);
    }
  }

  /// Once the inputs have been looked at, whoever goes on with the run may believe the items.
  void note_items(Recording& recording) {
    if (recording.unnoted.empty()) return;
    const Clock::time_point before = Clock::now();
    const bool right = inputs.holds(recording.source.stage);
    const Clock::duration took = Clock::now() - before;
    looking = looking.load() + took;
    if (right)
      for (const KeptItem& item : recording.unnoted)
        journal->add(stages[recording.stage].key, recording.output.port, item);
    recording.unnoted.clear();
  }

  bool is_resumable(const Recording& recording) const {
    const PlannedStage& stage = plan.stages[recording.source.stage];
    return stage.info.map && stage.streams[recording.source.port];
  }

  void finish(Recording& recording) {
    note_items(recording);
    const bool right = inputs.holds(recording.source.stage);
    const std::lock_guard lock(mutex);
    StageRecording& stage = stages[recording.stage];
    if (!recording.failed && right) stage.kept.outputs.push_back(std::move(recording.output));
    if (--stage.open > 0 || stage.kept.outputs.empty()) return;
    try {
      if (warnings)
        if (auto note = warnings->take(stage.kept.name, store))
          stage.kept.outputs.push_back(*std::move(note));
      kept.save(stage.key, stage.kept);
      if (journal)
        for (const KeptOutput& output : stage.kept.outputs)
          if (output.type != kNoteType) journal->remove(stage.key, output.port);
    } catch (const std::exception& error) {
      if (complaint.empty()) complaint = error.what();
    }
  }
};

Keeper::Keeper(const Plan& plan, const std::vector<StageKey>& keys, const Reuse& reuse,
               const std::vector<PlannedSource>& wanted, Keep keep, const InputCheck& inputs,
               KeptStages& kept, ObjectStore& store, ItemJournal* journal, WarningMemory* warnings)
    : state_(new State{plan, inputs, kept, store, journal, warnings, {}, {}, {}, {}}) {
  if (keep == Keep::kNothing) return;
  std::set<std::pair<std::size_t, std::size_t>> read;
  for (const PlannedSource& source : wanted) read.emplace(source.stage, source.port);
  for (std::size_t i = 0; i < plan.stages.size(); ++i) {
    if (!is_made(reuse.fates[i])) continue;
    for (const auto& source : plan.stages[i].inputs)
      if (source) read.emplace(source->stage, source->port);
  }
  std::vector<std::size_t> place(plan.stages.size(), plan.stages.size());
  for (const auto& [stage, port] : read) {
    const PlannedStage& planned = plan.stages[stage];
    if (reuse.fates[stage] != Fate::kRuns || keys[stage].only_this_run) continue;
    if (keep == Keep::kValues && planned.streams[port] && !is_result(planned, port)) continue;
    if (place[stage] == plan.stages.size()) {
      place[stage] = state_->stages.size();
      state_->stages.push_back({keys[stage].digest, 0, {}});
      state_->stages.back().kept.name = planned.name;
    }
    ++state_->stages[place[stage]].open;
    const PortInfo& info = planned.info.outputs[port];
    state_->recordings.push_back({{stage, port},
                                  place[stage],
                                  {info.name, info.type, info.layout, false, {}},
                                  planned.info.inputs.empty(),
                                  0,
                                  {},
                                  false});
  }
}

Keeper::~Keeper() = default;

std::vector<Sink> Keeper::sinks() {
  std::vector<Sink> sinks;
  for (Recording& recording : state_->recordings) {
    const PlannedStage& stage = state_->plan.stages[recording.source.stage];
    sinks.push_back({fmt::format("{}{}.{}", kStorePrefix, stage.name,
                                 stage.info.outputs[recording.source.port].name),
                     recording.source,
                     [this, &recording](const AnyItem& item) { state_->take(recording, item); },
                     [this, &recording] { state_->finish(recording); }});
  }
  return sinks;
}

void Keeper::end() {
  for (Recording& recording : state_->recordings) state_->note_items(recording);
}

std::string Keeper::complaint() const {
  const std::lock_guard lock(state_->mutex);
  return state_->complaint;
}

}  // namespace stope
