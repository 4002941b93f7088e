#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "framework/executor/run_record.hpp"
#include "framework/pipeline/plan.hpp"
#include "framework/plugins/catalogue.hpp"
#include "framework/report/machine.hpp"
#include "framework/report/run_facts.hpp"
#include "framework/report/run_log.hpp"
#include "framework/report/tap_result.hpp"
#include "framework/report/written_output.hpp"

namespace stope::report {

/// A file the pipeline was read from.
struct FileRead {
  std::string path;
  std::string sha256;  ///< empty if it could not be read again
};

/// Everything the files of a run directory are made of.
struct ReportData {
  const Plan& plan;
  const Catalogue& catalogue;
  const RunFacts& facts;
  const RunRecord& record;
  const RunLog& log;
  Machine machine;
  std::vector<FileRead> files_read;
  std::vector<WrittenFile> outputs;
  std::vector<std::string> outputs_kept;  ///< of a run that did not end well: what an earlier left
  std::vector<std::string> outputs_beside;  ///< in outputs/ but not of this run, which ended well
  std::vector<TapResult> taps;
  std::vector<StageReuse> reuse;  ///< by stage of the plan; empty if nothing is known of it

  const TapResult* tap_at(const PlannedSource& source) const {
    for (const TapResult& tap : taps) {
      if (tap.source == source) return &tap;
    }
    return nullptr;
  }
  /// What is known of a stage's key and of where its outputs came from; or null.
  const StageReuse* reuse_of(std::size_t stage) const {
    return stage < reuse.size() ? &reuse[stage] : nullptr;
  }
  /// What an output is made of: the ports its export reads.
  std::vector<PlannedSource> sources_of(const PlannedOutput& output) const {
    std::vector<PlannedSource> sources;
    for (const auto& input : plan.stages[output.stage].inputs) {
      if (input) sources.push_back(*input);
    }
    return sources;
  }
};

}  // namespace stope::report
