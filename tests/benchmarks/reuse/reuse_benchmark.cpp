// What the store of results is worth and whether it can be trusted:
//   reuse_benchmark [seconds]
// runs a pipeline of twelve stages cold, unchanged and with one parameter of each stage changed;
// lets two processes write one store for so many seconds (default 600); flips bits; fills a disk.
#include <fmt/format.h>
#include <sys/mount.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "framework/cache/object_store.hpp"
#include "stope/random.hpp"
#include "tests/pipelines/stope_process.hpp"

namespace stope {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using testing::ProcessResult;

constexpr const char* kTwelve = R"(stope: 1
name: twelve
stages:
  scans: {use: source/synthetic_pit, params: {size: 260 m, benches: 2, scans: 60}}
  cloud: {use: map/point_cloud, in: {scans: scans.scans, trajectory: scans.trajectory}}
  live: {use: rasterizer/height_difference, in: {cloud: cloud, trajectory: scans.trajectory}}
  prior: {use: prior/trajectory_dilation, in: scans.trajectory, params: {width: 16 m}}
  grid: {use: fusion/bayes, in: {prior: prior, live: live}}
  roads: {use: topology/voronoi, in: grid}
  plan: {use: planner/a_star, in: {roads: roads, grid: grid}}
  clearance: {use: metric/clearance, in: {roads: roads, grid: grid}}
  coverage: {use: metric/coverage, in: {roads: roads, grid: grid}}
  detour: {use: metric/detour, in: {roads: roads, grid: grid}, params: {pairs: 20}}
  junctions: {use: metric/junctions, in: {roads: roads, truth: scans.truth_roads}}
  apls: {use: metric/apls, in: {roads: roads, truth: scans.truth_roads}}
outputs:
  roads.geojson: roads
  plan.geojson: plan
  map.yaml: grid
)";

/// Of each stage one parameter, and another value than the pipeline's.
const std::vector<std::pair<std::string, std::string>> kChanges{
    {"scans", "rough=0.5"},
    {"cloud", "voxel=0.25"},
    {"live", "min_points=3"},
    {"prior", "margin=6"},
    {"grid", "prior_weight=0.9"},
    {"roads", "simplify=0.3"},
    {"plan", "step=2"},
    {"clearance", "occupied_threshold=0.6"},
    {"coverage", "occupied_threshold=0.6"},
    {"detour", "pairs=21"},
    {"junctions", "within=7"},
    {"apls", "spacing=40"}};

struct Timed {
  json printed;
  double seconds = 0;
};

class Bench {
 public:
  Bench() { testing::write_file(pipeline(), kTwelve); }

  Timed run(std::vector<std::string> more) const {
    std::vector<std::string> arguments{"run", pipeline().string(), "--out", out().string(),
                                       "--json"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const auto begin = std::chrono::steady_clock::now();
    const ProcessResult result =
        testing::stope(arguments, {{"STOPE_CACHE", (folder_.path() / "store").string()}});
    const double seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    if (result.exit_code != 0) {
      fmt::print("a run failed:\n{}{}\n", result.out, result.err);
      std::exit(1);
    }
    return {json::parse(result.out), seconds};
  }
  json record() const { return json::parse(testing::read_file(out() / "run.json")); }
  fs::path pipeline() const { return folder_.path() / "twelve.yaml"; }
  fs::path out() const { return folder_.path() / "run"; }
  const fs::path& folder() const { return folder_.path(); }

 private:
  testing::TemporaryFolder folder_;
};

/// The stage and all below it, by the wires that run.json tells of.
std::set<std::string> below(const json& record, const std::string& stage) {
  std::set<std::string> names{stage};
  for (const json& one : record.at("stages"))
    for (const auto& [port, from] : one.at("inputs").items()) {
      const auto text = from.get<std::string>();
      if (names.contains(text.substr(0, text.find('.')))) names.insert(one.at("name"));
    }
  return names;
}

std::set<std::string> stages_from(const json& record, const std::string& from) {
  std::set<std::string> names;
  for (const json& one : record.at("stages"))
    if (one.at("from") == from) names.insert(one.at("name"));
  return names;
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

bool twelve_stages(const Bench& bench) {
  const Timed cold = bench.run({"--keep", "all"});
  std::vector<double> warm;
  int ran = 0;
  for (int i = 0; i < 7; ++i) {
    const Timed again = bench.run({"--keep", "all"});
    ran += again.printed.at("stages").at("run").get<int>();
    warm.push_back(again.seconds);
  }
  fmt::print(
      "twelve stages and three exports: cold {:.2f} s; unchanged {} stages ran, median "
      "{:.3f} s, max {:.3f} s (whole command)\n",
      cold.seconds, ran, median(warm), *std::max_element(warm.begin(), warm.end()));
  bool right = ran == 0 && median(warm) < 1;
  for (const auto& [stage, change] : kChanges) {
    const Timed changed = bench.run({"--keep", "all", "--set", stage + "." + change});
    const json record = bench.record();
    const auto expected = below(record, stage), found = stages_from(record, "run");
    const auto reopened = stages_from(record, "reopened");
    fmt::print("  {}.{}: {} ran{} {:.2f} s: {}\n", stage, change, found.size(),
               reopened.empty() ? "," : fmt::format(", {} reopened,", fmt::join(reopened, ", ")),
               changed.seconds, found == expected ? "it and what is below" : "WRONG");
    right = right && found == expected;
  }
  return right;
}

void overhead() {
  std::vector<double> without, values, all;
  for (int i = 0; i < 5; ++i) {
    const Bench bench;
    without.push_back(bench.run({"--no-cache"}).seconds);
    values.push_back(bench.run({}).seconds);
    fs::remove_all(bench.folder() / "store");
    all.push_back(bench.run({"--keep", "all"}).seconds);
  }
  fmt::print(
      "cold, 5 each in turn: --no-cache median {:.2f} s ({:.2f} to {:.2f}), --keep values "
      "{:.2f} s, --keep all {:.2f} s\n",
      median(without), *std::min_element(without.begin(), without.end()),
      *std::max_element(without.begin(), without.end()), median(values), median(all));
}

/// Bytes of an object that can be told from its number alone.
std::string bytes_of(std::uint64_t number) {
  Random random(number);
  std::string bytes(random.below(200'000), ' ');
  for (std::size_t i = 0; i < bytes.size(); i += 1 + random.below(64))
    bytes[i] = static_cast<char>(random.bits());
  return bytes;
}

/// Writes, reads and now and then removes objects until the time is over. Gives the number of
/// objects whose bytes were wrong.
int work_on_store(const fs::path& root, double seconds, std::uint64_t seed) {
  ObjectStore store(root);
  Random random(seed);
  const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
  std::uint64_t wrong = 0, written = 0, read = 0;
  while (std::chrono::steady_clock::now() < end) {
    const std::uint64_t number = random.below(2000);  // both processes write the same objects
    const std::string bytes = bytes_of(number);
    Digester digester;
    digester.write(bytes.data(), bytes.size());
    if (random.below(2) == 0) {
      store.put([&](ByteSink& sink) { sink.write(bytes.data(), bytes.size()); });
      ++written;
    } else {
      std::string back;
      if (store.get(digester.digest(), [&](ByteSource& source) {
            back.resize(source.remaining());
            source.read(back.data(), back.size());
          })) {
        ++read;
        wrong += back != bytes ? 1 : 0;
      }
    }
    if (random.below(500) == 0) collect_garbage(store, 20'000'000);
  }
  fmt::print("  one process: {} objects written, {} read back, {} wrong\n", written, read, wrong);
  std::fflush(stdout);
  return wrong == 0 ? 0 : 1;
}

bool two_writers(double seconds) {
  const testing::TemporaryFolder folder;
  const fs::path root = folder.path() / "store";
  fmt::print("two processes on one store for {:.0f} s:\n", seconds);
  std::fflush(stdout);
  std::vector<pid_t> children;
  for (std::uint64_t seed : {1, 2}) {
    const pid_t child = ::fork();
    if (child == 0) ::_exit(work_on_store(root, seconds, seed));
    children.push_back(child);
  }
  bool right = true;
  for (const pid_t child : children) {
    int status = 0;
    ::waitpid(child, &status, 0);
    right = right && WIFEXITED(status) && WEXITSTATUS(status) == 0;
  }
  ObjectStore store(root);
  const std::uint64_t damaged = verify(store);
  fmt::print("  {} objects left, {} damaged\n", usage_of(store).objects, damaged);
  return right && damaged == 0;
}

bool flipped_bits(const Bench& bench) {
  bench.run({"--keep", "all"});
  const auto digests = testing::output_digests(bench.out());
  Random random(7);
  std::size_t flipped = 0;
  for (const auto& entry : fs::recursive_directory_iterator(bench.folder() / "store/objects")) {
    if (!entry.is_regular_file()) continue;
    std::string bytes = testing::read_file(entry.path());
    const std::size_t place = random.below(bytes.size());
    bytes[place] = static_cast<char>(bytes[place] ^ (1 << random.below(8)));
    testing::write_file(entry.path(), bytes);
    ++flipped;
  }
  const Timed mended = bench.run({"--keep", "all"});
  const bool same = testing::output_digests(bench.out()) == digests;
  const int left = bench.run({"--keep", "all"}).printed.at("stages").at("run").get<int>();
  fmt::print(
      "a bit flipped in each of {} objects: {} stages ran again, outputs {}; afterwards {} "
      "stages run\n",
      flipped, mended.printed.at("stages").at("run").get<int>(), same ? "the same" : "WRONG", left);
  return same && left == 0;
}

bool full_disk(const Bench& bench) {
  const fs::path small = bench.folder() / "small disk";
  fs::create_directory(small);
  if (::mount("none", small.c_str(), "tmpfs", 0, "size=256k") != 0) {
    fmt::print("a full disk: left out, as this needs the right to mount one\n");
    return true;
  }
  const auto result = testing::stope({"run", bench.pipeline().string(), "--out",
                                      bench.out().string(), "--cache", (small / "store").string()});
  ::umount(small.c_str());
  const bool said = result.err.find("not all could be taken from the store") != std::string::npos;
  fmt::print("a store on a disk of 256 KiB: exit code {}, {}\n", result.exit_code,
             said ? "and it was said" : "NOT SAID");
  return result.exit_code == 0 && said;
}

}  // namespace
}  // namespace stope

int main(int argc, char** argv) {
  using namespace stope;
  const double seconds = argc > 1 ? std::atof(argv[1]) : 600;
  const Bench bench;
  bool right = twelve_stages(bench);
  overhead();
  right = flipped_bits(Bench()) && right;
  right = full_disk(Bench()) && right;
  right = two_writers(seconds) && right;
  fmt::print("{}\n", right ? "all as it must be" : "NOT AS IT MUST BE");
  return right ? 0 : 1;
}
