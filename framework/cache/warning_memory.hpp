#pragma once

#include <cstdint>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "framework/cache/kept_stage.hpp"
#include "framework/cache/object_store.hpp"
#include "framework/executor/run.hpp"

namespace stope {

/// What a stage warned of. Whoever takes its results from the store must hear it, too.
struct StageWarnings {
  std::vector<std::string> sentences;  ///< in the order they were said, the first ones
  std::uint64_t more = 0;              ///< that were said beside them
  static constexpr void fields(auto& s, auto&& visit) {
    visit("sentences", s.sentences);
    visit("more", s.more);
  }
};

/// Passes on what is said in a run, and remembers what each stage warned of.
class WarningMemory final : public RunObserver {
 public:
  explicit WarningMemory(RunObserver& observer) : observer_(observer) {}
  void log(LogLevel level, const std::string& stage, const std::string& sentence) override;
  /// Writes what the stage has warned of, and nobody has taken yet, into the store, for its
  /// KeptStage; none if there is nothing. Throws Error if the disk is full.
  std::optional<KeptOutput> take(const std::string& stage, ObjectStore& store);

 private:
  RunObserver& observer_;
  std::mutex mutex_;
  std::map<std::string, StageWarnings> by_stage_;
};

/// Says again what a stage warned of when it was computed.
void repeat_warnings(const KeptStage& kept, const std::string& stage, ObjectStore& store,
                     RunObserver& observer);

}  // namespace stope
