#include "framework/compare/experiment/experiment.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "framework/compare/experiment/codes.hpp"
#include "framework/compare/experiment/metrics.hpp"
#include "framework/compare/experiment/variants.hpp"
#include "framework/pipeline/codes.hpp"
#include "framework/pipeline/path_check.hpp"
#include "framework/pipeline/sentence.hpp"
#include "framework/pipeline/yaml_reader.hpp"

namespace stope {
namespace {

constexpr std::size_t kMostRuns = 100'000;
constexpr int kMostPairs = 1000;

class ExperimentReader {
 public:
  ExperimentReader(const LocatedNode& root, Diagnostics& diagnostics)
      : root_(root), diagnostics_(diagnostics) {}

  Experiment read(const std::filesystem::path& file) {
    experiment_.file = file;
    experiment_.name = file.stem().string();
    // What is no experiment of this version has other keys, and each would be complained of.
    if (!check_version()) return std::move(experiment_);
    check_keys();
    if (const LocatedNode* name = text("name")) experiment_.name = name->text;
    read_base();
    if (const LocatedNode* set = value("set"))
      experiment_.overrides = overrides_in(*set, diagnostics_);
    read_arms();
    read_recordings();
    read_seeds();
    read_metrics();
    read_timing();
    check_count();
    return std::move(experiment_);
  }

 private:
  const LocatedNode* value(const char* key) const {
    const LocatedEntry* entry = root_.find(key);
    return entry ? &entry->value : nullptr;
  }

  const LocatedNode* text(const char* key) {
    const LocatedNode* node = value(key);
    if (!node || (node->is_scalar() && !node->text.empty())) return node;
    diagnostics_.error(code::kWrongKind, node->place,
                       fmt::format("'{}' must be a text, here stands {}.", key, kind_name(*node)));
    return nullptr;
  }

  const LocatedNode* needed(const char* key, const char* hint) {
    const LocatedNode* node = value(key);
    if (node && !node->is_empty()) return node;
    diagnostics_.error(code::kMissingKey, node ? node->place : Place{root_.place.file, 0, 0},
                       fmt::format("This experiment has no '{}'.", key), hint);
    return nullptr;
  }

  void check_keys() {
    static const std::vector<std::string> kKeys{
        "stope_experiment", "name",  "base",    "baseline", "set", "arms",
        "recordings",       "seeds", "metrics", "timing"};
    for (const LocatedEntry& entry : root_.entries)
      if (std::find(kKeys.begin(), kKeys.end(), entry.key) == kKeys.end())
        diagnostics_.error(code::kUnknownKey, entry.place,
                           fmt::format("An experiment has no key '{}'; it has {}.",
                                       shown(entry.key), quoted_list(kKeys, "and", 20)),
                           did_you_mean(entry.key, kKeys));
  }

  bool check_version() {
    const LocatedNode* version = value("stope_experiment");
    if (!version) {
      diagnostics_.error(code::kMissingKey, {root_.place.file, 0, 0},
                         root_.find("stope")
                             ? "This is a pipeline, not an experiment."
                             : "This file does not say that it is an experiment, and of which "
                               "version of the format.",
                         "An experiment begins with 'stope_experiment: 1' and names the pipeline "
                         "under 'base:'.");
    } else if (!version->is_scalar() || version->text != "1") {
      diagnostics_.error(code::kWrongVersion, version->place,
                         "This Stope reads version 1 of experiment files.",
                         "Write 'stope_experiment: 1'.");
    } else {
      return true;
    }
    return false;
  }

  void read_base() {
    if (!needed("base", "Write 'base: pipeline.yaml', the pipeline that the arms vary.")) return;
    const LocatedNode* base = text("base");
    if (!base) return;
    experiment_.base = absolute_path(base->text, base->folder);
    experiment_.base_place = base->place;
  }

  void read_arms() {
    const LocatedNode* node =
        needed("arms", "Write 'name: {stage.use: family/name}' for each variant of the pipeline.");
    if (!node) return;
    const bool right_so_far = !diagnostics_.has_errors();
    experiment_.arms = read_variants(*node, {"arm", true, false}, diagnostics_);
    if (experiment_.arms.size() == 1 && right_so_far && !diagnostics_.has_errors())
      diagnostics_.error(code::kTooFewArms, node->place,
                         "There is one arm, and nothing to compare it with.",
                         "Add an arm. One with nothing after the colon, such as 'plain:', is the "
                         "pipeline as it is.");
    const LocatedNode* baseline = text("baseline");
    if (!baseline) return;
    std::vector<std::string> names;
    for (const Variant& arm : experiment_.arms) names.push_back(arm.name);
    const auto found = std::find(names.begin(), names.end(), baseline->text);
    experiment_.baseline = static_cast<std::size_t>(found - names.begin());
    if (found == names.end())
      diagnostics_.error(
          code::kUnknownBaseline, baseline->place,
          fmt::format("There is no arm '{}' to be the baseline.", shown(baseline->text)),
          did_you_mean(baseline->text, names, fmt::format("There are {}.", quoted_list(names))));
  }

  void read_recordings() {
    if (const LocatedNode* node = value("recordings"); node && !node->is_empty())
      experiment_.recordings = read_variants(*node, {"recording", false, true}, diagnostics_);
    else
      experiment_.recordings.push_back({"base", root_.place, {}, {}, {}});
  }

  void read_seeds() {
    const LocatedNode* node = value("seeds");
    if (!node) {
      experiment_.seeds = {0};
      return;
    }
    if (!node->is_sequence() || node->items.empty())
      diagnostics_.error(code::kWrongKind, node->place,
                         fmt::format("'seeds' must be a list, here stands {}.",
                                     node->is_sequence() ? "one without a seed" : kind_name(*node)),
                         "Write 'seeds: [1, 2, 3]', or leave it out.");
    for (const LocatedNode& item : node->items) {
      const auto seed = seed_in(item, diagnostics_);
      if (!seed) continue;
      if (std::find(experiment_.seeds.begin(), experiment_.seeds.end(), *seed) !=
          experiment_.seeds.end())
        diagnostics_.error(code::kSameName, item.place,
                           fmt::format("The seed {} stands here twice.", *seed));
      experiment_.seeds.push_back(*seed);
    }
    for (const Variant& recording : experiment_.recordings)
      if (recording.seed)
        diagnostics_.error(code::kTwoSeeds, node->place,
                           fmt::format("The recording '{}' sets the run's seed itself, at {}.",
                                       recording.name, to_text(recording.place)),
                           "Leave 'seeds' out, or take the seed out of the recordings.");
  }

  void read_metrics() {
    if (const LocatedNode* node =
            needed("metrics",
                   "Write 'name: {from: stage, measure: figure, better: higher, matters: 0.01}'."))
      experiment_.metrics = stope::read_metrics(*node, diagnostics_);
  }

  void read_timing() {
    const LocatedNode* node = value("timing");
    if (!node) return;
    const LocatedEntry* pairs = node->find("pairs");
    const auto count = pairs ? seed_in(pairs->value, diagnostics_) : std::nullopt;
    if (count && node->entries.size() == 1 && *count >= 1 && *count <= kMostPairs)
      experiment_.timing_pairs = static_cast<int>(*count);
    else
      diagnostics_.error(code::kWrongKind, node->place,
                         "'timing' says how many pairs of runs are timed, 1 to 1000.",
                         "Write 'timing: {pairs: 5}'.");
  }

  void check_count() {
    const std::size_t runs =
        experiment_.arms.size() * experiment_.recordings.size() * experiment_.seeds.size();
    if (runs > kMostRuns)
      diagnostics_.error(
          code::kTooManyRuns, {root_.place.file, 0, 0},
          fmt::format("This experiment has {} runs; {} are the most.", runs, kMostRuns));
  }

  const LocatedNode& root_;
  Diagnostics& diagnostics_;
  Experiment experiment_;
};

}  // namespace

std::optional<Experiment> read_experiment(const std::filesystem::path& file,
                                          Diagnostics& diagnostics) {
  const auto source = read_source(file, {file.string(), 0, 0}, diagnostics);
  if (!source) return std::nullopt;
  const auto root = read_yaml(*source, diagnostics);
  if (!root) return std::nullopt;
  if (!root->is_map()) {
    diagnostics.error(code::kWrongKind, root->place,
                      fmt::format("An experiment is a map; this file holds {}.", kind_name(*root)),
                      "It begins with 'stope_experiment: 1'.");
    return std::nullopt;
  }
  Experiment experiment = ExperimentReader(*root, diagnostics).read(file);
  if (diagnostics.has_errors()) return std::nullopt;
  return experiment;
}

}  // namespace stope
