#pragma once

#include <string>
#include <vector>

#include "framework/compare/verdicts.hpp"

namespace stope::report {

/// A table or a text that the page offers and that stands beside it as a file.
struct Download {
  const char* name;   ///< `verdicts.csv`
  const char* media;  ///< `text/csv`
  const char* what;   ///< `one line an arm and metric`
  std::string text;
};

/// verdicts.csv, measures.csv, stage_times.csv and verdicts.json; timings.csv if any were taken.
std::vector<Download> downloads_of(const Comparison& comparison,
                                   const std::vector<ArmVerdicts>& verdicts);

/// One line an arm and metric; CSV as RFC 4180, a point in numbers, empty where there is none.
std::string verdicts_csv(const Comparison& comparison, const std::vector<ArmVerdicts>& verdicts);
/// One line a cell and metric, of all cells.
std::string measures_csv(const Comparison& comparison);
/// One line a cell and stage.
std::string stage_times_csv(const Comparison& comparison);
/// One line a pair of runs taken in turns.
std::string timings_csv(const Comparison& comparison);
/// What was found, and the figures it was found from.
std::string verdicts_json(const Comparison& comparison, const std::vector<ArmVerdicts>& verdicts);

}  // namespace stope::report
