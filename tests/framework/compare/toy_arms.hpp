#pragma once

#include <filesystem>
#include <fstream>
#include <functional>
#include <limits>
#include <map>
#include <mutex>
#include <numeric>
#include <sstream>
#include <string>
#include <vector>

#include "framework/plugins/catalogue.hpp"
#include "stope/stope.hpp"

/// Stages to compare, small enough to know by heart what each arm must give: numbers are drawn,
/// scaled or shifted, and their mean is measured.
namespace stope::toy {

/// How often stages have run, by what they were told to be called.
class Executions {
 public:
  void add(const std::string& what) {
    const std::lock_guard lock(mutex_);
    ++counts_[what];
  }
  std::map<std::string, int> take() {
    const std::lock_guard lock(mutex_);
    return std::exchange(counts_, {});
  }

 private:
  std::mutex mutex_;
  std::map<std::string, int> counts_;
};
inline Executions executions;

struct Numbers {
  static constexpr std::string_view kType = "toy/Numbers@1";
  std::vector<double> values;
  static constexpr void fields(auto& s, auto&& visit) { visit("values", s.values); }
};

/// What somebody else does to the files meanwhile.
inline std::function<void()> before_drawing, after_drawing;

/// Draws numbers in [0, 1) from the run's seed, or reads them from a file.
class Draw final : public Stage {
 public:
  struct Params {
    std::int64_t count = 5;
    std::optional<std::filesystem::path> file;
  } params;
  OutValue<Numbers> numbers;
  static void describe(About<Draw>& about) {
    about.summary("Draws numbers.")
        .output("numbers", &Draw::numbers)
        .param("count", &Params::count, "How many.")
        .param("file", &Params::file, existing(PathKind::kFile), "Where they are written.");
  }
  void run(Context& context) override {
    executions.add("draw");
    Numbers drawn;
    if (params.file) {
      if (before_drawing) before_drawing();
      std::ifstream in(*params.file);
      for (double value = 0; in >> value;) drawn.values.push_back(value);
      if (after_drawing) after_drawing();
    } else {
      Random random(context.seed());
      for (std::int64_t i = 0; i < params.count; ++i) drawn.values.push_back(random.uniform());
    }
    numbers.set(std::move(drawn));
  }
};

/// Multiplies, with noise of its own if asked.
class Scale final : public Map<Numbers(Numbers)> {
 public:
  struct Params {
    double factor = 1;
    double noise = 0;
    bool fails = false;
  } params;
  static void describe(About<Scale>& about) {
    about.summary("Multiplies.")
        .ports("numbers", "changed")
        .param("factor", &Params::factor, "By what.")
        .param("noise", &Params::noise, "What is added at most.")
        .param("fails", &Params::fails, "Whether it fails.");
  }
  Numbers apply(const Numbers& numbers, Context& context) const {
    executions.add("scale");
    if (params.fails) throw Error("the scales are broken");
    Random random(context.seed());
    Numbers changed = numbers;
    for (double& value : changed.values)
      value = value * params.factor + params.noise * random.uniform();
    return changed;
  }
};

/// Adds, and gives a number that is none if asked.
class Shift final : public Map<Numbers(Numbers)> {
 public:
  struct Params {
    double by = 1;
    bool spoils = false;
  } params;
  static void describe(About<Shift>& about) {
    about.summary("Adds.")
        .ports("numbers", "changed")
        .param("by", &Params::by, "What.")
        .param("spoils", &Params::spoils, "Whether it makes a number that is none.");
  }
  Numbers apply(const Numbers& numbers, Context&) const {
    executions.add("shift");
    Numbers changed = numbers;
    for (double& value : changed.values) value += params.by;
    if (params.spoils) changed.values.push_back(std::numeric_limits<double>::quiet_NaN());
    return changed;
  }
};

class Mean final : public Map<Measures(Numbers)> {
 public:
  struct Params {
  } params;
  static void describe(About<Mean>& about) {
    about.summary("Measures the mean.").ports("numbers", "measures");
  }
  Measures apply(const Numbers& numbers, Context&) const {
    executions.add("mean");
    const double sum = std::accumulate(numbers.values.begin(), numbers.values.end(), 0.0);
    return {{"mean", "count"},
            {sum / static_cast<double>(numbers.values.size()),
             static_cast<double>(numbers.values.size())},
            {"m", ""},
            {"", ""}};
  }
};

/// A mean of a few numbers that are drawn by the run's seed.
class Sample final : public Map<Measures(Numbers)> {
 public:
  struct Params {
  } params;
  static void describe(About<Sample>& about) {
    about.summary("Measures the mean of some.").ports("numbers", "measures");
  }
  Measures apply(const Numbers& numbers, Context& context) const {
    executions.add("sample");
    Random random = context.random();
    double sum = 0;
    constexpr int kDrawn = 20;
    for (int i = 0; i < kDrawn; ++i) sum += numbers.values[random.below(numbers.values.size())];
    return {{"mean"}, {sum / kDrawn}, {"m"}, {""}};
  }
};

/// Another measure, with another figure.
class Number final : public Map<Measures(Numbers)> {
 public:
  struct Params {
    bool fails = false;
  } params;
  static void describe(About<Number>& about) {
    about.summary("Measures the number.")
        .ports("numbers", "measures")
        .param("fails", &Params::fails, "Whether it fails.");
  }
  Measures apply(const Numbers& numbers, Context&) const {
    executions.add("count");
    if (params.fails) throw Error("the fingers are too few");
    return {{"count"}, {static_cast<double>(numbers.values.size())}, {""}, {""}};
  }
};

class Text final : public Map<Artefact(Numbers)> {
 public:
  struct Params {
  } params;
  static void describe(About<Text>& about) {
    about.summary("Writes numbers as text.").ports("numbers", "artefact").writes({"txt"});
  }
  Artefact apply(const Numbers& numbers, Context&) const {
    executions.add("text");
    std::ostringstream text;
    text.precision(17);
    for (const double value : numbers.values) text << value << '\n';
    const std::string all = text.str();
    return {{{"txt", {all.begin(), all.end()}}}};
  }
};

class ArmsCatalogue final : public Catalogue {
 public:
  ArmsCatalogue() {
    add<Draw>("toy/draw");
    add<Scale>("toy/scale");
    add<Shift>("toy/shift");
    add<Mean>("toy/mean");
    add<Sample>("toy/sample");
    add<Number>("toy/count");
    add<Text>("toy/text");
  }
  const std::vector<StageRecord>& stages() const override { return records_; }
  const StageRecord* find(std::string_view id) const override {
    for (const StageRecord& record : records_)
      if (record.info.id == id) return &record;
    return nullptr;
  }
  std::unique_ptr<StageInstance> create(std::string_view id) const override {
    return makers_.at(std::string(id))();
  }

 private:
  template <class S>
  void add(const std::string& id) {
    StageInfo info = InstanceOf<S>(id).info();
    info.map = S::kMap;
    records_.push_back({std::move(info), {}, "toy", "1", ""});
    makers_[id] = [id] { return std::make_unique<InstanceOf<S>>(id); };
  }
  std::vector<StageRecord> records_;
  std::map<std::string, std::function<std::unique_ptr<StageInstance>()>> makers_;
};

inline constexpr const char* kPipeline = R"(
stope: 1
stages:
  draw: {use: toy/draw}
  change: {use: toy/scale, in: draw}
  mean: {use: toy/mean, in: change}
outputs:
  changed.txt: change
)";

}  // namespace stope::toy
