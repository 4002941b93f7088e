#pragma once

#include <chrono>
#include <filesystem>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

#include "framework/report/pending_file.hpp"
#include "stope/context.hpp"

namespace stope::report {

/// A line of the run's log.
struct LogLine {
  double seconds = 0;  ///< since the run began
  LogLevel level = LogLevel::kInfo;
  std::string stage;  ///< empty: the run as a whole
  std::string sentence;
};

/// Keeps log.txt, and of it what the report shows. Any thread may add lines. A disk that is full
/// ends the file's growth, not the run; finish() then says so.
class RunLog {
 public:
  explicit RunLog(const std::filesystem::path& file);
  void add(LogLevel level, std::string_view stage, std::string_view sentence);
  /// Brings the file to the disk. Throws Error if it could not be written.
  void close();
  void commit() { file_.commit(); }

  /// The first warnings (at most 200), and how many there were.
  const std::vector<LogLine>& warnings() const { return warnings_; }
  std::size_t warning_count() const { return warning_count_; }
  /// The last lines of level info and above (at most 60).
  std::vector<LogLine> last_lines() const;

 private:
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  std::mutex mutex_;
  PendingFile file_;
  std::string failure_;
  std::vector<LogLine> warnings_, recent_;
  std::size_t warning_count_ = 0, line_count_ = 0;
};

}  // namespace stope::report
