// How far verdicts can be believed: comparisons of equal arms that are called different, intervals
// that miss the true difference, and planted differences that are found. Everything is drawn, with
// fixed seeds: the same figures on every machine. Arguments: [comparisons a cell, 200] [equal,
// twins, missed, at_delta or planted].
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <string>

#include "framework/compare/statistics/sign_flip.hpp"
#include "framework/compare/verdicts.hpp"
#include "noisy_pairs.hpp"

namespace stope::testing {
namespace {

constexpr std::array kSizes{6, 8, 10, 20};

bool different(const ComparedMeasure& compared) {
  return compared.verdict == Verdict::kBetter || compared.verdict == Verdict::kWorse;
}

/// How many of `trials` comparisons satisfy `wanted`, which gets all their measures.
template <class Wanted>
int count(const Drawn& drawn, int trials, Wanted&& wanted) {
  int found = 0;
  for (int trial = 0; trial < trials; ++trial) {
    Random random(mix_seed(1, static_cast<std::uint64_t>(trial)));
    const auto seed = static_cast<std::uint64_t>(trial);
    found += wanted(compare(drawn_pairs(drawn, random), seed)) ? 1 : 0;
  }
  return found;
}

/// Equal arms: comparisons with any measure called better or worse.
void false_alarms(int trials) {
  fmt::print(
      "\nEqual arms: comparisons of {} with a false alarm (asked: at most 17 of 200). Each with 1 "
      "and 4 measures at once, and 4 measures with 3 seeds a recording\n{:<17}",
      trials, "");
  for (const int size : kSizes) fmt::print("{:>22}", fmt::format("{} recordings", size));
  int all = 0, worst = 0, cells = 0;
  for (const Noise noise : kAllNoises) {
    fmt::print("\n{:<17}", name_of(noise));
    for (const int size : kSizes) {
      std::string text;
      for (const auto& [measures, seeds] : {std::pair(1, 1), {4, 1}, {4, 3}}) {
        const int alarms =
            count({noise, size, measures, seeds, 0, 1}, trials, [](const auto& compared) {
              return std::any_of(compared.begin(), compared.end(), different);
            });
        text += fmt::format("{:>5}", alarms);
        all += alarms, worst = std::max(worst, alarms), ++cells;
      }
      fmt::print("{:>22}", text);
      std::fflush(stdout);
    }
  }
  fmt::print("\nmost {}; all {} of {}: {:.2f} %\n", worst, all, cells * trials,
             100.0 * all / (cells * trials));
}

/// A baseline and `arms` others that are equal to it, then a twin of each of these; by one measure
/// that takes `values` values, so that arms also coincide by luck. Their files tell no more than
/// the measure does, which is the hard case: two that coincide everywhere are taken for twins.
Comparison drawn_twins(int arms, int recordings, std::uint64_t values, bool files_tell,
                       Random& random) {
  Comparison made;
  made.seeds = {0};
  made.metrics = {{"m", "m", "m", Direction::kHigher, 1, ""}};
  for (int i = 0; i < recordings; ++i) made.recordings.push_back({std::to_string(i), {}, {}});
  for (int i = 0; i <= 2 * arms; ++i) made.arms.push_back({std::to_string(i), {}, {}, {}});
  made.cells = empty_cells(made);
  for (ComparedCell& cell : made.cells) {
    const auto own = static_cast<std::size_t>(arms);
    cell.status = CellStatus::kDone;
    cell.measures = cell.arm <= own ? std::vector{static_cast<double>(random.below(values))}
                                    : made.cell(cell.arm - own, cell.recording, 0).measures;
    const std::string file = files_tell ? fmt::format("{} {}", cell.arm, cell.recording) : "same";
    cell.artefacts = {{"f", "f", file, 1, CellArtefact::Kind::kGeojson, false}};
  }
  return made;
}

/// Equal arms some of which are twins: that these are counted once must not raise the alarms.
void twins(int trials) {
  fmt::print(
      "\nThree equal arms and a twin of each: comparisons of {} with a false alarm, all six "
      "counted "
      "and twins counted once (asked: at most 5 %)\n{:<17}",
      10 * trials, "");
  for (const int size : kSizes) fmt::print("{:>18}", fmt::format("{} recordings", size));
  for (const std::uint64_t values : {2U, 3U, 5U, 1000U}) {
    fmt::print("\n{:<17}", fmt::format("{} values", values));
    for (const int size : kSizes) {
      int alarms[2] = {};
      for (const bool files_tell : {true, false})
        for (int trial = 0; trial < 10 * trials; ++trial) {
          Random random(mix_seed(3, static_cast<std::uint64_t>(trial)));
          const auto verdicts = verdicts_of(drawn_twins(3, size, values, files_tell, random));
          const bool any = std::any_of(verdicts.begin(), verdicts.end(), [](const auto& arm) {
            return different(arm.measures.front());
          });
          alarms[files_tell ? 0 : 1] += any ? 1 : 0;
        }
      fmt::print("{:>18}", fmt::format("{:.2f} {:>6.2f} %", 10.0 * alarms[0] / trials,
                                       10.0 * alarms[1] / trials));
      std::fflush(stdout);
    }
  }
  fmt::print("\n");
}

/// How often a single measure's interval misses the truth, the two ways of making one side by side,
/// and how often its sign-flip chance is below 0.05.
void missed(int trials) {
  fmt::print(
      "\nOne measure, {} times: true difference outside the 95 % interval, plain BCa and the one "
      "that is used; chance below 0.05 where there is no difference; the two of them, %\n{:<17}",
      trials, "");
  for (const int size : kSizes) fmt::print("{:>26}", fmt::format("{} recordings", size));
  const auto row = [&](std::string_view name, auto&& differences) {
    fmt::print("\n{:<17}", name);
    for (const int size : kSizes) {
      int plain = 0, used = 0, chance = 0, both = 0;
      for (int trial = 0; trial < trials; ++trial) {
        const auto seed = static_cast<std::uint64_t>(trial);
        Random random(mix_seed(2, seed));
        const std::vector<double> sample = differences(size, random);
        const BootstrapRules rules{0.95, 4000, seed};
        const bool misses = small_sample_interval(sample, mean_of, rules).excludes(0);
        const bool unlikely = sign_flip_probability(sample, seed) < 0.05;
        plain += bca_interval(sample, mean_of, rules).excludes(0) ? 1 : 0;
        used += misses ? 1 : 0, chance += unlikely ? 1 : 0, both += misses && unlikely ? 1 : 0;
      }
      std::string text;
      for (const int times : {plain, used, chance, both})
        text += fmt::format("{:>6.1f}", 100.0 * times / trials);
      fmt::print("{:>26}", text);
      std::fflush(stdout);
    }
  };
  for (const Noise noise : kAllNoises)
    row(name_of(noise), [&](int size, Random& random) {
      std::vector<double> differences;
      for (const Pair& pair : drawn_pairs({noise, size, 1, 1, 0, 1}, random)[0].pairs)
        differences.push_back(pair.arm - pair.baseline);
      return differences;
    });
  row("skewed itself", skewed_differences);
  fmt::print("\n");
}

/// A true difference of exactly delta: what must seldom be called one that matters, or the same.
void at_delta(int trials) {
  fmt::print(
      "\nA true difference of exactly delta, {} comparisons: 'it matters' and 'the same', %; noise "
      "of a paired difference as a multiple of delta\n{:<17}",
      trials, "");
  for (const int size : kSizes) fmt::print("{:>18}", fmt::format("{} recordings", size));
  for (const Noise noise : kAllNoises)
    for (const double of_delta : {0.5, 2.0}) {
      fmt::print("\n{:<17}", fmt::format("{}, {}", name_of(noise), of_delta));
      for (const int size : kSizes) {
        const double delta = 1 / of_delta;
        const Drawn drawn{noise, size, 1, 1, delta, delta};
        int matters = 0;
        const int same = count(drawn, trials, [&](const auto& compared) {
          matters += different(compared[0]) && compared[0].matters() ? 1 : 0;
          return compared[0].verdict == Verdict::kSame;
        });
        fmt::print("{:>18}",
                   fmt::format("{:.1f} {:>5.1f}", 100.0 * matters / trials, 100.0 * same / trials));
        std::fflush(stdout);
      }
    }
  fmt::print("\n");
}

/// A difference of 2 delta in one measure of several.
void found(int trials) {
  fmt::print(
      "\nA planted difference of 2 delta: found 'better' (and 'it matters'), % of {} (asked: 80). "
      "Noise of a paired difference as a multiple of delta\n{:<34}",
      trials, "");
  constexpr std::array kNoises{0.5, 1.0, 1.5, 2.0, 3.0};
  for (const double of_delta : kNoises) fmt::print("{:>13}", fmt::format("{} delta", of_delta));
  for (const Noise noise : {Noise::kNormal, Noise::kHeavy, Noise::kSkewed})
    for (const int measures : {1, 4})
      for (const int size : {6, 8, 10, 12, 20}) {
        fmt::print("\n{:<34}", fmt::format("{}, {} recordings, {}", name_of(noise), size,
                                           measures == 1 ? "1 measure" : "4 measures"));
        for (const double of_delta : kNoises) {
          const Drawn drawn{noise, size, measures, 1, 2 / of_delta, 1 / of_delta};
          int matters = 0;
          const int better = count(drawn, trials, [&](const auto& compared) {
            const bool is_better = compared[0].verdict == Verdict::kBetter;
            matters += is_better && compared[0].matters() ? 1 : 0;
            return is_better;
          });
          fmt::print("{:>13}", fmt::format("{:.0f} ({:.0f})", 100.0 * better / trials,
                                           100.0 * matters / trials));
        }
        std::fflush(stdout);
      }
  fmt::print("\n");
}

}  // namespace
}  // namespace stope::testing

int main(int count, char** arguments) {
  const int trials = count > 1 ? std::atoi(arguments[1]) : 200;
  const std::string part = count > 2 ? arguments[2] : "all";
  const auto wanted = [&](const char* name) { return part == "all" || part == name; };
  if (wanted("equal")) stope::testing::false_alarms(trials);
  if (wanted("twins")) stope::testing::twins(trials);
  if (wanted("missed")) stope::testing::missed(10 * trials);
  if (wanted("at_delta")) stope::testing::at_delta(5 * trials);
  if (wanted("planted")) stope::testing::found(trials);
}
