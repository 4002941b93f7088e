// What the executor itself costs: networks of stages that do next to nothing, at capacity 16, with
// tracing and the memory budget on, as in every run. Prints medians of several runs.
#include <sys/resource.h>

#include <algorithm>
#include <cstdlib>
#include <functional>
#include <iomanip>
#include <iostream>
#include <vector>

#include "tests/framework/executor/bench_of_stages.hpp"
#include "tests/framework/executor/toy_stages.hpp"

namespace stope::toy {
namespace {

constexpr std::int64_t kItems = 200'000;
constexpr int kRuns = 7;

struct Cost {
  double wall = 0, processor = 0;  ///< ns
};

double processor_time() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return 1e9 * static_cast<double>(usage.ru_utime.tv_sec + usage.ru_stime.tv_sec) +
         1e3 * static_cast<double>(usage.ru_utime.tv_usec + usage.ru_stime.tv_usec);
}

Cost median_cost(const std::function<void(PlanBuilder&)>& build, int threads) {
  std::vector<double> walls, processor;
  for (int run = 0; run < kRuns; ++run) {
    PlanBuilder bench;
    bench.options.threads = threads;
    bench.stage<Count>("count", {}, {{"count", kItems}});
    build(bench);
    const double begin = processor_time();
    const RunRecord record = bench.run();
    processor.push_back(processor_time() - begin);
    if (record.end != RunRecord::End::kDone) {
      std::cerr << record.sentence << "\n";
      std::exit(1);
    }
    walls.push_back(static_cast<double>(record.wall));
  }
  std::sort(walls.begin(), walls.end());
  std::sort(processor.begin(), processor.end());
  return {walls[kRuns / 2], processor[kRuns / 2]};
}

void print(const std::string& what, const Cost& cost, std::int64_t count, double target) {
  const auto each = static_cast<double>(count);
  std::cout << std::left << std::setw(64) << what << std::right << std::setw(6) << std::fixed
            << std::setprecision(0) << cost.wall / each << " ns, at most " << target << " ("
            << cost.processor / each << " ns of processor time)\n";
}

std::string chain(PlanBuilder& bench, int stages) {
  std::string last = "count.numbers";
  for (int i = 0; i < stages; ++i) {
    std::string name = "pass";
    name += std::to_string(i);
    bench.stage<Pass>(name, {{"numbers", last}});
    last = name + ".same";
  }
  return last;
}

void run() {
  for (const int stages : {0, 1, 4}) {
    const Cost cost = median_cost(
        [&](PlanBuilder& bench) {
          const std::string last = chain(bench, stages);
          bench.stage<Sum>("sum", {{"numbers", last}});
        },
        1);
    print("sequential stages, a chain of " + std::to_string(stages + 1) +
              " channels, per item and channel",
          cost, kItems * (stages + 1), 1000);
  }
  const Cost fan = median_cost(
      [&](PlanBuilder& bench) {
        for (const char* name : {"a", "b", "c", "d"})
          bench.stage<Sum>(name, {{"numbers", "count.numbers"}});
      },
      1);
  print("one output read by 4 stages, per item and channel", fan, kItems * 4, 1000);
  for (const int threads : {1, 2, 8}) {
    const Cost cost = median_cost(
        [&](PlanBuilder& bench) {
          bench.stage<Square>("square", {{"number", "count.numbers"}})
              .stage<Sum>("sum", {{"numbers", "square.square"}});
        },
        threads);
    print("source, map, sum on " + std::to_string(threads) + " threads, per item", cost, kItems,
          3000);
  }
}

}  // namespace
}  // namespace stope::toy

int main() { stope::toy::run(); }
