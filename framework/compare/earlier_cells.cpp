#include "framework/compare/earlier_cells.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <random>
#include <sstream>

#include "framework/compare/comparison_json.hpp"
#include "framework/pipeline/quantity.hpp"
#include "stope/error.hpp"

namespace stope {
namespace {

std::optional<std::string> text_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) return std::nullopt;
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

std::string random_name() {
  std::random_device device;
  return fmt::format("{:08x}{:08x}", device(), device());
}

bool files_are_there(const std::filesystem::path& folder, const ComparedCell& cell) {
  return std::all_of(cell.artefacts.begin(), cell.artefacts.end(), [&](const CellArtefact& file) {
    std::error_code error;
    const auto size = std::filesystem::file_size(folder / file.path, error);
    return !error && size == file.bytes;
  });
}

}  // namespace

EarlierCells::EarlierCells(const CompareJob& job) : id_(random_name()) {
  const std::filesystem::path file = job.options.folder / "comparison.json";
  const auto text = text_of(file);
  if (!text) return;
  try {
    earlier_ = read_comparison_json(*text);
  } catch (const Error& error) {
    throw Error(
        fmt::format("{} cannot be gone on with: {}. Move it away, or choose another folder "
                    "with --out.",
                    file.string(), error.what()));
  }
  if (earlier_->name != job.experiment.name)
    throw Error(
        fmt::format("{} holds the comparison '{}', not '{}'. Choose another folder with "
                    "--out.",
                    job.options.folder.string(), earlier_->name, job.experiment.name));
  id_ = earlier_->id;
}

bool EarlierCells::take_over_units(Comparison& comparison) const {
  for (ComparedMetric& metric : comparison.metrics)
    for (const ComparedMetric& old : earlier_->metrics) {
      if (old.name != metric.name || old.stage != metric.stage || old.measure != metric.measure)
        continue;
      // The figure's own unit; what matters may be said anew, in another one.
      const Conversion delta = convert({metric.smallest_that_matters, metric.unit}, old.unit);
      if (!delta.value) return false;
      metric.smallest_that_matters = *delta.value;
      metric.unit = old.unit;
    }
  return true;
}

const std::vector<TimedPair>& EarlierCells::timings() const {
  static const std::vector<TimedPair> kNone;
  return earlier_ ? earlier_->timings : kNone;
}

std::size_t EarlierCells::take_over(Comparison& comparison) const {
  if (!earlier_ || !take_over_units(comparison)) return 0;
  std::size_t kept = 0;
  for (ComparedCell& cell : comparison.cells) {
    if (cell.status != CellStatus::kPending) continue;
    const auto found =
        std::find_if(earlier_->cells.begin(), earlier_->cells.end(), [&](const ComparedCell& old) {
          return old.status == CellStatus::kDone && old.folder == cell.folder &&
                 old.key == cell.key && old.measures.size() == comparison.metrics.size();
        });
    if (found == earlier_->cells.end() || !files_are_there(comparison.folder, *found)) continue;
    const ComparedCell place = cell;
    cell = *found;
    cell.arm = place.arm;
    cell.recording = place.recording;
    cell.seed = place.seed;
    cell.run_seed = place.run_seed;
    for (const Exclusion& exclusion : earlier_->exclusions)
      if (exclusion.arm == comparison.arms[cell.arm].name &&
          exclusion.recording == comparison.recordings[cell.recording].name &&
          exclusion.seed == cell.run_seed)
        comparison.exclusions.push_back(exclusion);
    ++kept;
  }
  return kept;
}

}  // namespace stope
