// Each hostile plugin is put into a folder beside a good one. It must be named with the reason, and
// the good one must load.
#include <gtest/gtest.h>
#include <stdlib.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <vector>

#include "framework/plugins/floating_point_modes.hpp"
#include "framework/plugins/plugin_catalogue.hpp"

namespace stope {
namespace {

namespace fs = std::filesystem;

class HostilePlugins : public ::testing::Test {
 protected:
  HostilePlugins() {
    std::string name = (fs::temp_directory_path() / "stope-hostile-XXXXXX").string();
    if (!::mkdtemp(name.data())) throw Error("cannot make the temporary folder " + name);
    folder_ = fs::canonical(name);
    add("good");
  }
  ~HostilePlugins() override { fs::remove_all(folder_); }

  /// Puts a built plugin into the folder.
  fs::path add(const std::string& name) const {
    const fs::path file = folder_ / (name + ".so");
    fs::copy_file(fs::path(HOSTILE_PLUGINS) / (name + ".so"), file);
    return file;
  }
  /// Puts the good plugin into the folder a second time, changed.
  fs::path add_changed(const std::string& name,
                       const std::function<void(std::vector<char>&)>& change) const {
    std::ifstream good(fs::path(HOSTILE_PLUGINS) / "good.so", std::ios::binary);
    std::vector<char> bytes{std::istreambuf_iterator<char>(good), std::istreambuf_iterator<char>()};
    change(bytes);
    const fs::path file = folder_ / (name + ".so");
    std::ofstream(file, std::ios::binary)
        .write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    return file;
  }
  PluginCatalogue catalogue(std::chrono::milliseconds limit = std::chrono::seconds(60)) const {
    PluginOptions options;
    options.search.places = {folder_};
    options.manifests = folder_ / "manifests";
    options.probe_limit = limit;
    return PluginCatalogue(options);
  }
  /// Expects that the file is left out with this status and a sentence that holds
  /// `part`, while the good plugin is usable.
  void expect_refused(const fs::path& path, PluginStatus status, const std::string& part,
                      std::chrono::milliseconds limit = std::chrono::seconds(60)) const {
    const PluginCatalogue plugins = catalogue(limit);
    EXPECT_NE(plugins.find("hostile/good"), nullptr);
    EXPECT_NO_THROW(plugins.create("hostile/good"));
    EXPECT_EQ(plugins.stages().size(), 1U);
    const auto file = std::find_if(plugins.files().begin(), plugins.files().end(),
                                   [&](const PluginFile& f) { return f.path == path; });
    ASSERT_NE(file, plugins.files().end());
    EXPECT_EQ(status_name(file->status), status_name(status)) << file->sentence;
    EXPECT_FALSE(file->usable());
    EXPECT_NE(file->sentence.find(part), std::string::npos) << file->sentence;
    EXPECT_TRUE(file->stages.empty());
  }

  fs::path folder_;
};

constexpr std::size_t kClass = 4, kByteOrder = 5, kMachine = 18;  // places in the ELF header

TEST_F(HostilePlugins, NoNote) {
  expect_refused(add("no_note"), PluginStatus::kNoNote, "carries no Stope note");
}

TEST_F(HostilePlugins, WrongEpoch) {
  expect_refused(add("wrong_epoch"), PluginStatus::kOtherEpoch,
                 "built for ABI epoch " + std::to_string(kAbiEpoch + 1) +
                     ", this Stope has epoch " + std::to_string(kAbiEpoch) + ": rebuild it");
}

TEST_F(HostilePlugins, OtherEigenAlignment) {
  expect_refused(add("other_alignment"), PluginStatus::kBuiltOtherwise,
                 "Eigen types aligned to 32 bytes, this Stope to 16: rebuild it without");
}

TEST_F(HostilePlugins, FastMath) {
  expect_refused(add("fast_math"), PluginStatus::kBuiltOtherwise, "built with -ffast-math");
}

TEST_F(HostilePlugins, FloatingPointModesFlippedThoughTheNoteSaysNothing) {
  const FloatingPointModes before = floating_point_modes();
  expect_refused(add("flips_modes"), PluginStatus::kFloatingPoint,
                 "changes the floating-point modes when it is opened");
  EXPECT_EQ(floating_point_modes(), before);
}

TEST_F(HostilePlugins, Truncated) {
  const fs::path file =
      add_changed("truncated", [](std::vector<char>& bytes) { bytes.resize(bytes.size() / 2); });
  expect_refused(file, PluginStatus::kTruncated, "It is truncated");
}

TEST_F(HostilePlugins, TruncatedAnywhere) {
  for (const std::size_t size : {4U, 15U, 16U, 63U, 64U, 100U, 1000U, 5000U}) {
    const fs::path file =
        add_changed("truncated", [size](std::vector<char>& bytes) { bytes.resize(size); });
    expect_refused(file, PluginStatus::kTruncated, "It is truncated");
  }
}

TEST_F(HostilePlugins, LastByteMissing) {
  const fs::path file =
      add_changed("truncated", [](std::vector<char>& bytes) { bytes.pop_back(); });
  expect_refused(file, PluginStatus::kTruncated, "the table of sections lies beyond");
}

TEST_F(HostilePlugins, CrashOnLoad) {
  expect_refused(add("crash_on_load"), PluginStatus::kCrashed,
                 "crashed (SIGSEGV) while being opened");
}

TEST_F(HostilePlugins, CrashInDescribe) {
  expect_refused(add("aborts_in_describe"), PluginStatus::kCrashed,
                 "crashed (SIGABRT) while describing its stage 'hostile/aborts_in_describe'");
}

TEST_F(HostilePlugins, HangOnLoad) {
  catalogue();  // knows the good one from here on, so that the short limit is for the other alone
  expect_refused(add("hang_on_load"), PluginStatus::kHung, "still being opened after 0.3 s",
                 std::chrono::milliseconds(300));
}

TEST_F(HostilePlugins, HangOnLoadWithThePipeClosed) {
  catalogue();
  expect_refused(add("hang_up_and_hang"), PluginStatus::kHung, "still being opened after 0.3 s",
                 std::chrono::milliseconds(300));
}

TEST_F(HostilePlugins, QuietExitOnLoad) {
  expect_refused(add("quiet_exit_on_load"), PluginStatus::kExited,
                 "ended the process that opened it, while being opened");
}

TEST_F(HostilePlugins, ExitHandlersOfTheHostDoNotRunInTheProbe) {
  static const fs::path kTouched = folder_ / "touched";
  std::atexit([] { std::ofstream(kTouched) << "by an exit handler"; });
  expect_refused(add("polite_exit_on_load"), PluginStatus::kExited,
                 "ended the process that opened it, while being opened");
  EXPECT_FALSE(fs::exists(kTouched));
}

TEST_F(HostilePlugins, MissingSymbol) {
  expect_refused(add("missing_symbol"), PluginStatus::kFailed,
                 "undefined symbol: no_library_has_this_function");
}

TEST_F(HostilePlugins, NoEntry) {
  expect_refused(add("no_entry"), PluginStatus::kFailed, "does not export the symbol stope_plugin");
}

TEST_F(HostilePlugins, OtherArchitecture) {
  const fs::path file =
      add_changed("other_machine", [](std::vector<char>& bytes) { bytes[kMachine] = 8; });
  expect_refused(file, PluginStatus::kOtherMachine,
                 "It was built for machine number 8, this Stope");
}

TEST_F(HostilePlugins, ThirtyTwoBits) {
  const fs::path file =
      add_changed("other_machine", [](std::vector<char>& bytes) { bytes[kClass] = 1; });
  expect_refused(file, PluginStatus::kOtherMachine, "built for a 32-bit machine");
}

TEST_F(HostilePlugins, OtherByteOrder) {
  const fs::path file =
      add_changed("other_machine", [](std::vector<char>& bytes) { bytes[kByteOrder] = 2; });
  expect_refused(file, PluginStatus::kOtherMachine, "built for a big-endian machine");
}

TEST_F(HostilePlugins, NotALibrary) {
  const fs::path file = folder_ / "letter.so";
  std::ofstream(file) << "Dear miner,\n";
  expect_refused(file, PluginStatus::kNotALibrary, "It is not a library");
}

TEST_F(HostilePlugins, EmptyFile) {
  const fs::path file = folder_ / "empty.so";
  std::ofstream(file).close();
  expect_refused(file, PluginStatus::kNotALibrary, "It is not a library");
}

TEST_F(HostilePlugins, LinkToNothing) {
  const fs::path file = folder_ / "dangling.so";
  fs::create_symlink("/nowhere/at/all.so", file);
  expect_refused(file, PluginStatus::kFailed, "No such file or directory");
}

TEST_F(HostilePlugins, ExceptionInDescribe) {
  expect_refused(
      add("throws_in_describe"), PluginStatus::kFailed,
      "Its stage 'hostile/throws_in_describe' cannot describe itself: the moon is in the "
      "wrong phase");
}

TEST_F(HostilePlugins, OneStageTwiceInOneFile) {
  expect_refused(add("duplicate_stage"), PluginStatus::kInvalid,
                 "It offers the stage 'hostile/innocent' twice");
}

TEST_F(HostilePlugins, DefaultOutsideItsLimits) {
  expect_refused(add("impossible_default"), PluginStatus::kInvalid,
                 "the default -1 of 'width' is outside its own limits");
}

TEST_F(HostilePlugins, OtherLayoutOfAPayload) {
  expect_refused(add("other_layout"), PluginStatus::kOtherLayout,
                 "lays stope/Measures@1 out otherwise than this Stope: rebuild it");
}

TEST_F(HostilePlugins, OneStageInTwoFiles) {
  const fs::path twin = add("twin");
  const fs::path other = add("other_twin");
  const PluginCatalogue plugins = catalogue();
  EXPECT_EQ(plugins.stages().size(), 1U);
  EXPECT_EQ(plugins.find("hostile/innocent"), nullptr);
  const std::string expected = "The stage 'hostile/innocent' is offered by " + other.string() +
                               " and " + twin.string() +
                               ": neither is used. Remove one of the files.";
  EXPECT_EQ(plugins.conflict("hostile/innocent"), expected);
  EXPECT_THROW(plugins.create("hostile/innocent"), Error);
  for (const PluginFile& file : plugins.files()) {
    if (file.plugin_id == "good") continue;
    EXPECT_EQ(status_name(file.status), "duplicate-stage");
    EXPECT_EQ(file.sentence, expected);
  }
}

TEST_F(HostilePlugins, ThrowInTheConstructorOfAStage) {
  const fs::path file = add("throwing_constructor");
  const PluginCatalogue plugins = catalogue();
  EXPECT_NO_THROW(plugins.create("hostile/good"));
  try {
    plugins.create("hostile/throwing_constructor");
    FAIL() << "the stage was made";
  } catch (const Error& error) {
    EXPECT_EQ(std::string(error.what()),
              file.string() +
                  ": its stage 'hostile/throwing_constructor' cannot be made: the licence server "
                  "cannot be reached");
  }
}

TEST_F(HostilePlugins, AllAtOnceLeaveTheGoodOnesUsable) {
  for (const auto& entry : fs::directory_iterator(HOSTILE_PLUGINS)) {
    const std::string name = entry.path().stem().string();
    if (entry.path().extension() == ".so" && name != "good" && !name.starts_with("hang_")) {
      add(name);
    }
  }
  const PluginCatalogue plugins = catalogue();
  EXPECT_GE(plugins.files().size(), 17U);
  std::vector<std::string> usable;
  for (const StageRecord& stage : plugins.stages()) usable.push_back(stage.info.id);
  EXPECT_EQ(usable, (std::vector<std::string>{"hostile/good", "hostile/throwing_constructor"}));
}

}  // namespace
}  // namespace stope
