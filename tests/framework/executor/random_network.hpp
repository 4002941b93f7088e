#pragma once

#include <algorithm>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "tests/framework/executor/bench_of_stages.hpp"
#include "tests/framework/executor/stress_stages.hpp"

namespace stope::toy {

/// A random network of stress stages together with what each of its outputs must carry, worked out
/// stage by stage with plain vectors.
class RandomNetwork {
 public:
  struct Sample {
    Stamp stamp = 0;
    std::uint64_t index = 0;
    std::int64_t value = 0;
    bool operator==(const Sample&) const = default;
  };

  RandomNetwork(std::uint64_t seed, std::size_t stages) : random_(seed) {
    add_source();
    while (outputs_.size() < stages) add_stage();
    // Every output that nothing reads yet is collected, and some others.
    for (const Output& output : outputs_) {
      if (output.readers == 0 || random_.below(4) == 0) collect(output);
    }
  }

  PlanBuilder& bench() { return bench_; }
  /// Lets the stage `number` (modulo their count) fail at its operation `at`.
  void break_stage(std::uint64_t number, std::int64_t at) {
    PlannedStage& stage = bench_.plan.stages[number % bench_.plan.stages.size()];
    for (std::size_t i = 0; i < stage.parameters.size(); ++i) {
      if (stage.info.parameters[i].name == "fail_at") stage.parameters[i] = at;
    }
  }
  void make_sources_endless() {
    for (PlannedStage& stage : bench_.plan.stages) {
      for (std::size_t i = 0; i < stage.parameters.size(); ++i) {
        if (stage.info.parameters[i].name == "count") stage.parameters[i] = std::int64_t{-1};
      }
    }
  }
  const std::map<std::string, std::vector<Sample>>& expected() const { return expected_; }
  const std::map<std::string, std::vector<Sample>>& collected() const { return collected_; }

 private:
  struct Output {
    std::string name;
    bool stream = true;
    std::vector<Sample> samples;
    int readers = 0;
  };

  Output& any(bool stream) {
    std::vector<Output*> list;
    for (Output& output : outputs_) {
      if (output.stream == stream) list.push_back(&output);
    }
    Output& chosen = *list[random_.below(list.size())];
    ++chosen.readers;
    return chosen;
  }
  bool has_value() const {
    return std::any_of(outputs_.begin(), outputs_.end(),
                       [](const Output& output) { return !output.stream; });
  }

  template <class S>
  void add(const PlanBuilder::Wires& wires, std::vector<Sample> samples, bool stream = true,
           PlanBuilder::Parameters parameters = {}) {
    std::string name = "s";
    name += std::to_string(outputs_.size());
    parameters["seed"] = static_cast<std::int64_t>(random_.below(1000));
    bench_.stage<S>(name, wires, parameters);
    outputs_.push_back({name + ".out", stream, std::move(samples), 0});
  }

  void add_source() {
    const auto count = static_cast<std::int64_t>(random_.below(60));
    std::vector<Sample> samples;
    for (std::int64_t i = 0; i < count; ++i)
      samples.push_back(
          {StressSource::stamp(i), static_cast<std::uint64_t>(2 * i), StressSource::value(i)});
    add<StressSource>({}, samples, true, {{"count", count}});
  }

  void add_stage() {
    switch (random_.below(8)) {
      case 0:
        return add_source();
      case 1:
      case 2: {
        const Output& a = any(true);
        std::vector<Sample> samples = a.samples;
        std::int64_t sum = 0;
        for (Sample& sample : samples) sample.value = sum = sum * 3 % 100'003 + sample.value;
        return add<StressRunningSum>({{"a", a.name}}, samples);
      }
      case 3: {
        const Output& a = any(true);
        const Output& b = any(true);
        std::vector<Sample> samples = a.samples;
        samples.insert(samples.end(), b.samples.begin(), b.samples.end());
        std::stable_sort(samples.begin(), samples.end(),
                         [](const Sample& x, const Sample& y) { return x.stamp < y.stamp; });
        for (std::size_t i = 0; i < samples.size(); ++i) samples[i].index = i;
        return add<StressJoin>({{"a", a.name}, {"b", b.name}}, samples);
      }
      case 4: {
        const Output& a = any(true);
        const std::uint64_t most = random_.below(2) == 0 ? 1'000'000 : random_.below(20);
        Sample total;
        for (std::size_t i = 0; i < a.samples.size() && i < most; ++i)
          total.value += a.samples[i].value;
        return add<StressTotal>({{"a", a.name}}, {total}, false,
                                {{"most", static_cast<std::int64_t>(most)}});
      }
      case 5: {
        if (!has_value()) return;
        const Output& a = any(true);
        const Output& b = any(false);
        std::vector<Sample> samples = a.samples;
        for (Sample& sample : samples) sample.value += b.samples[0].value;
        return add<StressLate>({{"a", a.name}, {"b", b.name}}, samples);
      }
      case 6: {
        if (!has_value()) return;
        const Output& a = any(true);
        const Output& b = any(false);
        std::vector<Sample> samples = a.samples;
        for (Sample& sample : samples) sample.value += 2 * b.samples[0].value;
        return add<StressAdd>({{"a", a.name}, {"b", b.name}}, samples);
      }
      default: {
        const Output& a = any(true);
        std::vector<Sample> samples = a.samples;
        for (Sample& sample : samples) sample.value *= 3;
        return add<StressAdd>({{"a", a.name}, {"b", a.name}}, samples);
      }
    }
  }

  void collect(const Output& output) {
    expected_[output.name] = output.samples;
    std::vector<Sample>& into = collected_[output.name];
    bench_.sink(output.name, [&into](const AnyItem& item) {
      into.push_back({item.stamp, item.index, Item<Number>(item)->value});
    });
  }

  Random random_;
  PlanBuilder bench_;
  std::vector<Output> outputs_;
  std::map<std::string, std::vector<Sample>> expected_, collected_;
};

}  // namespace stope::toy
