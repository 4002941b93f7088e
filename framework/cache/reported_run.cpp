#include "framework/cache/reported_run.hpp"

#include <fmt/format.h>

#include <utility>
#include <vector>

namespace stope {
namespace {

StageReuse::From from_of(Fate fate) {
  switch (fate) {
    case Fate::kRuns:
      return StageReuse::From::kRun;
    case Fate::kReopened:
      return StageReuse::From::kReopened;
    case Fate::kStored:
      return StageReuse::From::kStore;
    case Fate::kNotNeeded:
      return StageReuse::From::kNotNeeded;
  }
  return StageReuse::From::kRun;
}

std::vector<StageReuse> reuse_of_all(const CachedRun& run) {
  std::vector<StageReuse> list;
  for (std::size_t i = 0; i < run.keys().size(); ++i)
    list.push_back(stage_reuse(run.keys()[i], run.reuse().fates.at(i)));
  return list;
}

/// Gives a report what was seen at welcome outputs in earlier runs, and notes what it sees in this.
class Memory {
 public:
  Memory(CachedRun& run, const Plan& plan, RunReport& report)
      : run_(run), plan_(plan), report_(report) {}

  std::vector<Sink> sinks(const Reuse& reuse) {
    const std::vector<report::TapResult> known = what_is_known(reuse);
    std::vector<Sink> sinks = report_.sinks([&](const PlannedSource& source) {
      for (const report::TapResult& result : known)
        if (result.source == source) return false;
      return is_to_be_had(source, reuse);
    });
    for (const report::TapResult& result : known) report_.know(result);
    return sinks;
  }

  void note(const Reuse& reuse) {
    for (const PlannedSource& source : report_.welcome()) {
      if (reuse.fates[source.stage] != Fate::kRuns) continue;
      const report::TapResult result = report_.seen(source);
      run_.note(source.stage, name_of(source), [&](ByteSink& sink) { encode(result, sink); });
    }
  }

 private:
  std::string name_of(const PlannedSource& source) const {
    // A port's name holds no blank. What earlier Stopes drew, under another name, held pixels and
    // cannot be read any more.
    return fmt::format("drawn at {}", plan_.stages[source.stage].info.outputs[source.port].name);
  }

  std::vector<report::TapResult> what_is_known(const Reuse& reuse) {
    std::vector<report::TapResult> known;
    for (const PlannedSource& source : report_.welcome()) {
      if (reuse.fates[source.stage] == Fate::kRuns) continue;
      report::TapResult result;
      if (!run_.noted(source.stage, name_of(source),
                      [&](ByteSource& bytes) { decode(result, bytes); }))
        continue;
      result.source = source;
      known.push_back(std::move(result));
    }
    return known;
  }

  bool is_to_be_had(const PlannedSource& source, const Reuse& reuse) const {
    if (is_made(reuse.fates[source.stage])) return true;
    const PortInfo& port = plan_.stages[source.stage].info.outputs[source.port];
    return reuse.fates[source.stage] == Fate::kStored && reuse.stored[source.stage].find(port);
  }

  CachedRun& run_;
  const Plan& plan_;
  RunReport& report_;
};

}  // namespace

StageReuse stage_reuse(const StageKey& key, Fate fate) {
  StageReuse reuse;
  reuse.from = from_of(fate);
  reuse.key = key.digest.text();
  for (const KeyPart& part : key.parts) reuse.parts.emplace_back(part.name, part.value);
  reuse.only_this_run = key.only_this_run;
  return reuse;
}

RunRecord run_and_report(CachedRun& run, const Plan& plan, RunReport& report,
                         const RunOptions& options,
                         const std::function<void(const RunProgress&)>& progress) {
  Memory memory(run, plan, report);
  RunRecord record = run.run(
      report.needed(), [&](const Reuse& reuse) { return memory.sinks(reuse); }, options, progress);
  if (record.end == RunRecord::End::kDone) memory.note(run.reuse());
  report.set_reuse(reuse_of_all(run));
  return record;
}

}  // namespace stope
