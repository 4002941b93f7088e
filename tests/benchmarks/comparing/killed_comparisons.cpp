// What is computed twice: at most the stages that ran after the kill and had begun before it
// (computed_twice.hpp), as a share of what all stages take, by the same clock. Beside it the
// processor time of the killed process and of the one that goes on, in which starting and reading
// what is stored count, too, less that of undisturbed ones, which differ by some per cent among
// each other.
#include "tests/benchmarks/comparing/killed_comparisons.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <random>
#include <set>
#include <stdexcept>

#include "tests/benchmarks/comparing/computed_twice.hpp"
#include "tests/benchmarks/comparing/measured_process.hpp"

namespace stope::benchmark {
namespace {

namespace fs = std::filesystem;

constexpr int kUndisturbed = 3;
constexpr const char* kExperiment = R"(stope_experiment: 1
name: killed
base: {}/pipelines/measure/mapped_grid.yaml
arms:
  cross:
    roads.use: [topology/voronoi, topology/watershed, topology/skeleton, topology/region_growing]
    live.obstacle_height: [0.4 m, 0.6 m]
recordings:
  cross: {{seed: [1, 2, 3, 4, 5]}}
metrics:
  apls: {{from: apls, better: higher, matters: 0.01}}
  coverage: {{from: coverage, better: higher, matters: 0.01}}
)";

/// sha256 by path, of all that the comparison lists.
std::map<std::string, std::string> artefacts(const fs::path& out) {
  std::map<std::string, std::string> files;
  const auto comparison = nlohmann::json::parse(text_of(out / "comparison.json"));
  if (!comparison.at("complete")) throw std::runtime_error("a comparison is not complete");
  for (const auto& cell : comparison.at("cells"))
    for (const auto& file : cell.at("artefacts")) files[file.at("path")] = file.at("sha256");
  return files;
}

/// What the store knows of: names of files below stages/.
std::set<std::string> stored_keys(const fs::path& store) {
  std::set<std::string> keys;
  std::error_code none;
  for (const auto& entry : fs::recursive_directory_iterator(store / "stages", none))
    if (entry.is_regular_file())
      keys.insert(entry.path().parent_path().filename().string() +
                  entry.path().filename().string());
  return keys;
}

}  // namespace

bool kill_comparisons(int times) {
  const WorkFolder work;
  write_text(work.path() / "e.yaml", fmt::format(fmt::runtime(kExperiment), STOPE_SOURCE_DIR));
  const auto arguments = [&](const std::string& name) {
    return std::vector<std::string>{"compare",   (work.path() / "e.yaml").string(),
                                    "--out",     (work.path() / name / "out").string(),
                                    "--cache",   (work.path() / name / "store").string(),
                                    "--threads", "2",
                                    "-q"};
  };
  std::vector<double> walls, processors;
  std::map<std::string, double> seconds;
  for (int time = 0; time < kUndisturbed; ++time) {
    fs::remove_all(work.path() / "whole");
    const MeasuredProcess whole = run_stope(arguments("whole"));
    if (whole.exit_code != 0) throw std::runtime_error("the comparison failed");
    walls.push_back(whole.wall);
    processors.push_back(whole.processor);
    // The least: a stage that had to wait for a core did not work longer.
    for (const auto& [key, of_stage] : stage_seconds(work.path() / "whole/out"))
      seconds[key] = seconds.contains(key) ? std::min(seconds[key], of_stage) : of_stage;
  }
  const double wall = median(walls), processor = median(processors);
  const auto wanted = artefacts(work.path() / "whole/out");
  double all = 0;
  for (const auto& [key, of_stage] : seconds) all += of_stage;
  fmt::print(
      "undisturbed: {:.1f} s, stages {:.1f} s, {:.1f} s of processor time ({:.1f} to {:.1f}), {} "
      "files\n",
      wall, all, processor, *std::min_element(processors.begin(), processors.end()),
      *std::max_element(processors.begin(), processors.end()), wanted.size());
  std::mt19937_64 random(20261128);
  std::vector<double> twice, longer;
  bool right = true;
  for (int time = 0; time < times;) {
    const double at = std::uniform_real_distribution<>(0.02, 0.98)(random) * processor;
    fs::remove_all(work.path() / "killed");
    const MeasuredProcess killed = run_stope(arguments("killed"), at);
    if (killed.exit_code == 0) continue;  // it was done sooner than the others
    ++time;
    const fs::path out = work.path() / "killed/out";
    const auto keys = stored_keys(work.path() / "killed/store");
    const std::string recording = unfinished_recording(out);
    const auto since = fs::file_time_type::clock::now();
    const MeasuredProcess rest = run_stope(arguments("killed"));
    const bool same = rest.exit_code == 0 && artefacts(out) == wanted;
    const std::size_t again = ran_again(out, keys, since);
    twice.push_back(most_computed_twice(out, recording, keys, seconds) / all);
    longer.push_back((killed.processor + rest.processor) / processor - 1);
    right = right && same && again == 0;
    fmt::print(
        "killed after {:5.1f} s of processor time ({}), {:5.1f} s more: {:+.1f} %; "
        "at most {:.1f} % computed twice; {} stored stages ran again, {}\n",
        killed.processor, recording, rest.processor, 100 * longer.back(), 100 * twice.back(), again,
        same ? "the same bytes" : "OTHER BYTES");
  }
  const double most = *std::max_element(twice.begin(), twice.end());
  fmt::print(
      "computed twice, at most: median {:.1f} %, most {:.1f} % (allowed: 10 %); processor time: "
      "median {:+.1f} %\n",
      100 * median(twice), 100 * most, 100 * median(longer));
  return right && most <= 0.10;
}

}  // namespace stope::benchmark
