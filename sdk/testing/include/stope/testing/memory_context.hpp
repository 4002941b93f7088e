#pragma once

#include <stdlib.h>

#include <filesystem>
#include <mutex>
#include <string>
#include <vector>

#include "stope/context.hpp"

namespace stope::testing {

/// A context for tests of a single stage: keeps its log, never cancels unless told to.
class MemoryContext final : public Context {
 public:
  explicit MemoryContext(std::uint64_t seed = 1) : seed_(seed) {}
  ~MemoryContext() override {
    if (!folder_.empty()) {
      std::error_code ignored;
      std::filesystem::remove_all(folder_, ignored);
    }
  }
  void log(LogLevel, std::string_view sentence) override {
    const std::lock_guard lock(mutex_);
    sentences.emplace_back(sentence);
  }
  void progress(double) override {}
  std::uint64_t seed() const override { return seed_; }
  void reseed(std::uint64_t seed) { seed_ = seed; }
  std::uint64_t index() const override { return item; }
  bool cancelled() const override { return cancel; }
  int threads() const override { return 2; }
  std::filesystem::path temporary_folder() override {
    const std::lock_guard lock(mutex_);
    if (folder_.empty()) {
      std::string name = (std::filesystem::temp_directory_path() / "stope-test-XXXXXX").string();
      if (!::mkdtemp(name.data())) throw Error("cannot make the temporary folder " + name);
      folder_ = name;
    }
    return folder_;
  }

  std::vector<std::string> sentences;
  bool cancel = false;
  std::uint64_t item = 0;  ///< index of the item in hand

 private:
  std::uint64_t seed_;
  std::mutex mutex_;
  std::filesystem::path folder_;
};

}  // namespace stope::testing
