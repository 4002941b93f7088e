#pragma once

#include <cstdint>
#include <filesystem>
#include <string_view>

#include "stope/error.hpp"
#include "stope/random.hpp"
#include "stope/visibility.hpp"

namespace stope {

enum class LogLevel : int { kDebug, kInfo, kWarning };

/// What the framework offers a running stage. Every method may be called from any thread of the
/// stage, and the context lives as long as the run: a lazy payload's loader may use it later.
class STOPE_API Context {
 public:
  virtual ~Context() = default;
  /// Writes a sentence to the run's log, with the stage's name and the item's time.
  virtual void log(LogLevel level, std::string_view sentence) = 0;
  /// How much of the work is done, 0 to 1. Sources that know their length call it; others need not.
  virtual void progress(double fraction) = 0;
  /// A seed that depends on the run's seed, the stage's name and, in a Map, the item's index;
  /// nothing else.
  virtual std::uint64_t seed() const = 0;
  /// Of a Map: the index of the item in hand, which ChangedWindow::since of later items refers to.
  virtual std::uint64_t index() const { return 0; }
  /// Whether the run is being stopped: long loops ask now and then and give up.
  virtual bool cancelled() const = 0;
  /// How many threads oneTBB has for this run. Results must not depend on it.
  virtual int threads() const = 0;
  /// An empty folder of the stage's own, removed after the run.
  virtual std::filesystem::path temporary_folder() = 0;

  void info(std::string_view sentence) { log(LogLevel::kInfo, sentence); }
  void warn(std::string_view sentence) { log(LogLevel::kWarning, sentence); }
  Random random() const { return Random(seed()); }
  void stop_if_cancelled() const {
    if (cancelled()) throw Cancelled();
  }
};

}  // namespace stope
