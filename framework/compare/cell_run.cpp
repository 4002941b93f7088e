#include "framework/compare/cell_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <utility>

#include "framework/compare/measure_reading.hpp"
#include "framework/report/run_report.hpp"
#include "stope/item.hpp"

namespace stope {
namespace {

CellArtefact::Kind kind_of(const std::string& path) {
  const std::string extension = std::filesystem::path(path).extension().string();
  if (extension == ".png") return CellArtefact::Kind::kPicture;
  if (extension == ".geojson") return CellArtefact::Kind::kGeojson;
  if (extension == ".json") return CellArtefact::Kind::kMeasures;
  return CellArtefact::Kind::kOther;
}

}  // namespace

struct CellRun::State {
  /// An output of the plan that metrics are read from; its sink alone writes it.
  struct Measured {
    PlannedSource source;
    std::optional<Measures> measures;
  };

  const Experiment& experiment;
  const PlannedArm& arm;
  MetricCheck& metrics;
  Comparison& comparison;
  ComparedCell& cell;
  RunReport report;
  std::vector<Measured> measured;

  const std::optional<Measures>& measures_at(const PlannedSource& source) const {
    return std::find_if(measured.begin(), measured.end(),
                        [&](const Measured& m) { return m.source == source; })
        ->measures;
  }

  void exclude(const std::string& metric, const std::string& sentence) {
    comparison.exclusions.push_back({comparison.arms[cell.arm].name,
                                     comparison.recordings[cell.recording].name, cell.run_seed,
                                     metric, sentence});
  }

  void check_metrics(const Measured& of) {
    for (std::size_t i = 0; i < arm.metrics.size(); ++i)
      if (arm.metrics[i] == of.source) metrics.look(cell.arm, cell.recording, i, *of.measures);
  }

  void read_measures() {
    cell.measures.clear();
    for (std::size_t i = 0; i < experiment.metrics.size(); ++i) {
      const MeasureReading reading =
          read_measure(experiment.metrics[i], measures_at(arm.metrics[i]), comparison.metrics[i]);
      cell.measures.push_back(reading.value);
      if (!reading.why_not.empty()) exclude(comparison.metrics[i].name, reading.why_not);
    }
  }

  void list_artefacts() {
    cell.artefacts.clear();
    for (const report::WrittenFile& file : report.outputs())
      cell.artefacts.push_back({file.output, cell.folder + "/" + file.path, file.sha256, file.bytes,
                                kind_of(file.path), file.companion});
  }
};

CellRun::CellRun(const Experiment& experiment, const PlannedArm& arm, const Catalogue& catalogue,
                 RunFacts facts, MetricCheck& metrics, Comparison& comparison, ComparedCell& cell)
    : state_(new State{
          experiment,
          arm,
          metrics,
          comparison,
          cell,
          RunReport(*arm.plan, catalogue, std::move(facts), comparison.folder / cell.folder),
          {}}) {
  for (const PlannedSource& source : arm.metrics) {
    const auto known = std::find_if(state_->measured.begin(), state_->measured.end(),
                                    [&](const State::Measured& m) { return m.source == source; });
    if (known == state_->measured.end()) state_->measured.push_back({source, {}});
  }
}

CellRun::~CellRun() = default;

ComparedCell& CellRun::cell() const { return state_->cell; }
const Plan& CellRun::plan() const { return *state_->arm.plan; }

std::vector<PlannedSource> CellRun::wanted() const {
  std::vector<PlannedSource> sources = state_->report.needed();
  for (const State::Measured& measured : state_->measured) sources.push_back(measured.source);
  return sources;
}

std::vector<Sink> CellRun::sinks() {
  std::vector<Sink> sinks = state_->report.sinks([](const PlannedSource&) { return false; });
  for (State::Measured& measured : state_->measured) {
    measured.measures.reset();
    sinks.push_back({fmt::format("measures of {}", plan().stages[measured.source.stage].name),
                     measured.source,
                     [this, &measured](const AnyItem& item) {
                       measured.measures = *Item<Measures>(item);
                       state_->check_metrics(measured);
                     },
                     {}});
  }
  return sinks;
}

void CellRun::log(LogLevel level, std::string_view stage, std::string_view sentence) {
  state_->report.log(level, stage, sentence);
}

void CellRun::finish(const RunRecord& record, std::vector<StageReuse> reuse) {
  state_->report.set_reuse(std::move(reuse));
  state_->report.finish(record);
  state_->list_artefacts();
  state_->read_measures();
  state_->cell.status = CellStatus::kDone;
}

void CellRun::fail(const RunRecord& record) {
  state_->report.finish(record);
  state_->cell.status = CellStatus::kFailed;
  state_->cell.sentence = record.sentence;
  state_->cell.failed_stage = record.failed_stage;
  state_->exclude("", record.sentence);
}

}  // namespace stope
