#pragma once

#include "framework/compare/run_comparison.hpp"
#include "tests/framework/compare/files_of_test.hpp"
#include "tests/framework/compare/toy_arms.hpp"

namespace stope::testing {

/// Runs toy experiments in a folder of its own, with a store of its own.
class ComparingTest : public FilesTest {
 protected:
  struct Log final : RunObserver {
    void log(LogLevel, const std::string&, const std::string& sentence) override {
      text += sentence + "\n";
    }
    std::string text;
  };

  /// Runs `stope_experiment: 1`, `base: pit.yaml` and this. Nothing is counted of what came before.
  Comparison compare(const std::string& rest, const std::atomic<bool>* stop = nullptr) {
    write("pit.yaml", toy::kPipeline);
    Diagnostics diagnostics;
    const auto experiment = read_experiment(
        write("e.yaml", "stope_experiment: 1\nbase: pit.yaml\n" + rest), diagnostics);
    std::optional<ExperimentPlan> plan;
    if (experiment) plan = plan_experiment(*experiment, catalogue_, diagnostics);
    EXPECT_TRUE(plan) << text_of(diagnostics);
    CompareOptions options;
    options.folder = folder() / "out";
    options.threads = 2;
    options.memory = std::size_t{1} << 30;
    if (!store_.empty()) options.cache.store = folder() / store_;
    options.stop = stop;
    options.time_again = time_again_;
    toy::executions.take();
    Comparison comparison = run_comparison({*experiment, *plan, catalogue_, options, log_});
    ran_ = toy::executions.take();
    return comparison;
  }
  /// What an arm left of the output changed.txt.
  std::string output(const std::string& arm, const std::string& recording = "base",
                     const std::string& seed = "0") {
    return read(folder() / "out/arms" / arm / recording / seed / "outputs/changed.txt");
  }

  std::string store_ = "store";  ///< empty: none
  toy::ArmsCatalogue catalogue_;
  Log log_;
  bool time_again_ = false;
  std::map<std::string, int> ran_;  ///< how often stages ran in the last comparison
};

}  // namespace stope::testing
