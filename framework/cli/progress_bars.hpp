#pragma once

#include <chrono>
#include <mutex>
#include <string>

#include "framework/executor/run.hpp"

namespace stope {

/// Shows a run on a terminal: a line for each stage with a bar, its rate and the time left, redrawn
/// in place; log sentences scroll above. Where there is no terminal it prints the sentences alone.
class ProgressBars final : public RunObserver {
 public:
  /// `terminal`: draw bars; `quiet`: print nothing but warnings.
  ProgressBars(bool terminal, bool quiet);
  ~ProgressBars() override;
  void log(LogLevel level, const std::string& stage, const std::string& sentence) override;
  void show(const RunProgress& progress);
  /// Removes the bars, so that what is printed next starts on a clean line.
  void finish();

 private:
  void erase();

  std::mutex mutex_;
  bool terminal_;
  bool quiet_;
  int lines_drawn_ = 0;
  std::string drawn_;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

/// One line: `roads      ########----  58 %   12 items  3.1 /s  0:04 left`. `seconds` is how long
/// the run has taken.
std::string progress_line(const RunProgress::Process& process, double seconds,
                          std::size_t name_width);

}  // namespace stope
