#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "framework/compare/statistics/verdict.hpp"
#include "framework/pipeline/overrides.hpp"
#include "framework/pipeline/quantity.hpp"

namespace stope {

/// An arm or a recording: what it changes in the pipeline.
struct Variant {
  std::string name;  ///< also of a folder: letters, digits and `_ - . = +`, no dot in front
  Place place;
  std::vector<Override> overrides;
  std::optional<LocatedNode> base;    ///< of an arm that varies another pipeline: its path
  std::optional<std::uint64_t> seed;  ///< of a recording that is made by the run's seed
};

/// A figure that arms are judged by.
struct ExperimentMetric {
  std::string name;
  std::string stage, port;  ///< who gives it; the port is empty if it goes without saying
  Place stage_place;
  std::string measure;  ///< its name in the Measures
  Place measure_place, matters_place;
  Direction direction = Direction::kHigher;
  Quantity smallest_that_matters;
};

/// An experiment file: which variants of a pipeline are compared, on what and by what.
struct Experiment {
  std::string name;
  std::filesystem::path file;
  std::filesystem::path base;
  Place base_place;
  std::vector<Override> overrides;  ///< of all arms, before their own
  std::vector<Variant> arms, recordings;
  std::size_t baseline = 0;  ///< place in `arms`
  std::vector<std::uint64_t> seeds;
  std::vector<ExperimentMetric> metrics;
  int timing_pairs = 0;  ///< 0: no timings

  /// Of a run: the recording's own, else the one of the list.
  std::uint64_t seed_of(std::size_t recording, std::size_t seed) const {
    return recordings[recording].seed.value_or(seeds[seed]);
  }
};

/// Reads an experiment file. Everything that is wrong with it is reported in one go, but for what
/// only the pipeline knows (plan_experiment() reports that); it is given if none of it is an error.
/// docs/comparing.md describes the format.
std::optional<Experiment> read_experiment(const std::filesystem::path& file,
                                          Diagnostics& diagnostics);

}  // namespace stope
