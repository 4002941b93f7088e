#include "framework/compare/comparison.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace stope {
namespace {

bool same_file(const CellArtefact& a, const CellArtefact& b) {
  return a.output == b.output && a.sha256 == b.sha256 && a.companion == b.companion;
}

// Bit for bit, so that two that are both not a number are the same.
bool same_measures(const std::vector<double>& a, const std::vector<double>& b) {
  return a.size() == b.size() &&
         (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0);
}

template <class F>
void for_cells_of_both(const Comparison& comparison, std::size_t recording, std::size_t arm,
                       std::size_t other, F&& visit) {
  for (std::size_t seed = 0; seed < comparison.seeds.size(); ++seed) {
    const ComparedCell& a = comparison.cell(arm, recording, seed);
    const ComparedCell& b = comparison.cell(other, recording, seed);
    if (a.status == CellStatus::kDone && b.status == CellStatus::kDone) visit(a, b);
  }
}

}  // namespace

std::vector<ComparedCell> empty_cells(const Comparison& comparison) {
  std::vector<ComparedCell> cells;
  for (std::size_t recording = 0; recording < comparison.recordings.size(); ++recording)
    for (std::size_t seed = 0; seed < comparison.seeds.size(); ++seed)
      for (std::size_t arm = 0; arm < comparison.arms.size(); ++arm) {
        ComparedCell& cell = cells.emplace_back();
        cell.arm = arm;
        cell.recording = recording;
        cell.seed = seed;
        cell.run_seed = comparison.seeds[seed];
      }
  return cells;
}

bool same_outputs(const ComparedCell& a, const ComparedCell& b) {
  return same_measures(a.measures, b.measures) &&
         std::equal(a.artefacts.begin(), a.artefacts.end(), b.artefacts.begin(), b.artefacts.end(),
                    same_file);
}

std::vector<std::vector<std::size_t>> distinct_recordings(const Comparison& comparison) {
  std::vector<std::vector<std::size_t>> all;
  for (std::size_t i = 0; i < comparison.recordings.size(); ++i) {
    const std::string& name = comparison.recordings[i].same_as;
    const auto known = std::find_if(all.begin(), all.end(), [&](const auto& names) {
      return !name.empty() && comparison.recordings[names.front()].name == name;
    });
    if (known == all.end())
      all.push_back({i});
    else
      known->push_back(i);
  }
  return all;
}

bool outputs_identical(const Comparison& comparison, std::size_t arm, std::size_t other) {
  bool any = false, same = true;
  for (std::size_t recording = 0; recording < comparison.recordings.size(); ++recording)
    for_cells_of_both(comparison, recording, arm, other,
                      [&](const ComparedCell& a, const ComparedCell& b) {
                        any = true;
                        same = same && same_outputs(a, b);
                      });
  return any && same;
}

std::vector<MeasuredPairs> measured_pairs(const Comparison& comparison, std::size_t arm) {
  const bool identical = outputs_identical(comparison, arm, comparison.baseline);
  const std::vector<std::vector<std::size_t>> recordings = distinct_recordings(comparison);
  std::vector<MeasuredPairs> all;
  for (std::size_t metric = 0; metric < comparison.metrics.size(); ++metric) {
    const ComparedMetric& of = comparison.metrics[metric];
    MeasuredPairs measured{of.name, of.direction, of.smallest_that_matters, {}, identical};
    for (const std::vector<std::size_t>& names : recordings) {
      double baseline_sum = 0, arm_sum = 0;
      std::size_t count = 0;
      for (const std::size_t recording : names)
        for_cells_of_both(
            comparison, recording, comparison.baseline, arm,
            [&](const ComparedCell& a, const ComparedCell& b) {
              if (!std::isfinite(a.measures[metric]) || !std::isfinite(b.measures[metric])) return;
              baseline_sum += a.measures[metric];
              arm_sum += b.measures[metric];
              ++count;
            });
      if (count == 0) continue;
      const auto runs = static_cast<double>(count);
      measured.pairs.push_back(
          {comparison.recordings[names.front()].name, baseline_sum / runs, arm_sum / runs});
    }
    all.push_back(std::move(measured));
  }
  return all;
}

}  // namespace stope
