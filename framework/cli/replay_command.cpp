#include <fmt/format.h>
#include <stdlib.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>
#include <system_error>

#include "framework/cache/earlier_run.hpp"
#include "framework/cache/replay.hpp"
#include "framework/cli/arguments.hpp"
#include "framework/cli/exit_code.hpp"
#include "framework/cli/interrupt.hpp"
#include "framework/cli/run_pipeline.hpp"
#include "framework/report/machine.hpp"
#include "framework/report/quantity_text.hpp"
#include "stope/error.hpp"

namespace stope {
namespace {

namespace fs = std::filesystem;

/// A folder for the second run, removed unless it is worth a look.
class Playground {
 public:
  Playground() {
    std::string name = (fs::temp_directory_path() / "stope-replay-XXXXXX").string();
    if (!::mkdtemp(name.data())) throw Error("cannot make the folder " + name);
    folder_ = name;
  }
  ~Playground() {
    std::error_code ignored;
    if (!kept_) fs::remove_all(folder_, ignored);
  }
  Playground(const Playground&) = delete;
  Playground& operator=(const Playground&) = delete;
  const fs::path& folder() const { return folder_; }
  void keep() { kept_ = true; }

 private:
  fs::path folder_;
  bool kept_ = false;
};

/// The arguments that run the recorded pipeline as it was run.
Arguments as_recorded(const Arguments& arguments, const EarlierRun& earlier) {
  Arguments recorded = arguments;
  recorded.pipeline = earlier.pipeline;
  recorded.overrides = earlier.overrides;
  recorded.seed = earlier.seed;
  recorded.no_cache = true;
  for (fs::path& place : recorded.plugin_path) place = fs::absolute(place);
  std::error_code error;
  // Paths in overrides are relative to it.
  fs::current_path(earlier.working_folder, error);
  if (error && !earlier.overrides.empty())
    throw Error(
        fmt::format("cannot enter {}, where the run was started and to which the paths of "
                    "its --set options are relative: {}",
                    earlier.working_folder.string(), error.message()));
  return recorded;
}

int say(const Arguments& arguments, const ReplayVerdict& verdict) {
  if (arguments.json) {
    nlohmann::ordered_json json;
    json["same"] = verdict.same();
    json["compared"] = verdict.compared;
    if (!verdict.same()) json["first_difference"] = verdict.differences.front();
    json["differences"] = verdict.differences;
    json["remarks"] = verdict.remarks;
    fmt::print("{}\n", json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
  } else if (verdict.same()) {
    fmt::print("The same: {}, bit for bit.\n",
               report::count_text(verdict.compared, "file", "files"));
    for (const std::string& remark : verdict.remarks) fmt::print("note: {}\n", remark);
  } else {
    fmt::print("Not the same. The first thing that differs: {}\n", verdict.differences.front());
    for (std::size_t i = 1; i < verdict.differences.size(); ++i)
      fmt::print("  also: {}\n", verdict.differences[i]);
    for (const std::string& remark : verdict.remarks) fmt::print("note: {}\n", remark);
  }
  return verdict.same() ? kDone : kRunFailed;
}

}  // namespace

int replay_command(const Arguments& arguments) {
  std::error_code ignored;
  const fs::path record =
      fs::absolute(fs::is_directory(arguments.record, ignored) ? arguments.record / "run.json"
                                                               : arguments.record);
  const EarlierRun earlier = read_earlier_run(record);
  if (earlier.end != "done")
    throw Error(
        fmt::format("the run of {} did not end well ({}), so that it left nothing to "
                    "compare with",
                    record.string(), earlier.end));
  const Arguments recorded = as_recorded(arguments, earlier);
  const LoadedPipeline loaded = load_pipeline(recorded);
  if (!loaded.plan) {
    if (const std::string changed = first_changed_file(earlier); !changed.empty())
      fmt::print(stderr, "note: {}\n", changed);
    return loaded.exit_code;
  }
  const Interrupt interrupt;
  Playground playground;
  try {
    const std::vector<StageKey> keys =
        keys_of(*loaded.plan, *loaded.catalogue, recorded.seed, &interrupt.flag());
    ReplayVerdict verdict = compare_before(earlier, *loaded.plan, keys, STOPE_VERSION);
    if (!verdict.same()) return say(arguments, verdict);
    const PipelineRun run =
        run_pipeline(loaded, recorded, {}, playground.folder(), interrupt.flag());
    if (run.record.end != RunRecord::End::kDone) {
      fmt::print(stderr, "error: {}\n", run.record.sentence);
      return kRunFailed;
    }
    compare_after(earlier, record.parent_path(), read_earlier_run(playground.folder() / "run.json"),
                  keys, *loaded.plan, verdict);
    if (!verdict.same()) {
      playground.keep();
      verdict.remarks.push_back(
          fmt::format("the second run is in {}", playground.folder().string()));
    }
    return say(arguments, verdict);
  } catch (const Cancelled&) {
    fmt::print(stderr, "Cancelled.\n");
    return kRunFailed;
  }
}

}  // namespace stope
