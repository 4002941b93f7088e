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
      }
  return cells;
}

bool outputs_identical(const Comparison& comparison, std::size_t arm, std::size_t other) {
  bool any = false, same = true;
  for (std::size_t recording = 0; recording < comparison.recordings.size(); ++recording)
    for_cells_of_both(comparison, recording, arm, other,
                      [&](const ComparedCell& a, const ComparedCell& b) {
                        any = true;
                        same = same && same_measures(a.measures, b.measures) &&
                               std::equal(a.artefacts.begin(), a.artefacts.end(),
                                          b.artefacts.begin(), b.artefacts.end(), same_file);
                      });
  return any && same;
}

std::vector<MeasuredPairs> measured_pairs(const Comparison& comparison, std::size_t arm) {
  const bool identical = outputs_identical(comparison, arm, comparison.baseline);
  std::vector<MeasuredPairs> all;
  for (std::size_t metric = 0; metric < comparison.metrics.size(); ++metric) {
    const ComparedMetric& of = comparison.metrics[metric];
    MeasuredPairs measured{of.name, of.direction, of.smallest_that_matters, {}, identical};
    for (std::size_t recording = 0; recording < comparison.recordings.size(); ++recording) {
      double baseline_sum = 0, arm_sum = 0;
      std::size_t count = 0;
      for_cells_of_both(
          comparison, recording, comparison.baseline, arm,
          [&](const ComparedCell& a, const ComparedCell& b) {
            if (!std::isfinite(a.measures[metric]) || !std::isfinite(b.measures[metric])) return;
            baseline_sum += a.measures[metric];
            arm_sum += b.measures[metric];
            ++count;
          });
      if (count == 0) continue;
      const auto seeds = static_cast<double>(count);
      measured.pairs.push_back(
          {comparison.recordings[recording].name, baseline_sum / seeds, arm_sum / seeds});
    }
    all.push_back(std::move(measured));
  }
  return all;
}

}  // namespace stope
