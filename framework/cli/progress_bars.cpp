#include "framework/cli/progress_bars.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace stope {
namespace {

constexpr std::size_t kBarWidth = 24;

std::string clock_text(double seconds) {
  const auto whole = std::lround(seconds);
  return whole >= 3600 ? fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60)
                       : fmt::format("{}:{:02}", whole / 60, whole % 60);
}

}  // namespace

std::string progress_line(const RunProgress::Process& process, double seconds,
                          std::size_t name_width) {
  const std::uint64_t items = std::max(process.items_read, process.items_written);
  const double fraction = process.finished ? 1.0 : process.fraction;
  std::string bar(kBarWidth, fraction < 0 ? ' ' : '-');
  if (fraction >= 0) {
    std::fill_n(bar.begin(), static_cast<std::size_t>(std::clamp(fraction, 0.0, 1.0) * kBarWidth),
                '#');
  }
  std::string line = fmt::format("{:<{}} [{}] ", process.name, name_width, bar);
  line += fraction >= 0 ? fmt::format("{:3.0f} % ", fraction * 100) : std::string("      ");
  line += fmt::format("{:>8} items", items);
  if (process.finished) return line + "  done";
  if (items > 0 && seconds > 0)
    line += fmt::format("  {:.1f} /s", static_cast<double>(items) / seconds);
  if (fraction > 0.01)
    line += fmt::format("  {} left", clock_text(seconds * (1 - fraction) / fraction));
  return line;
}

ProgressBars::ProgressBars(bool terminal, bool quiet) : terminal_(terminal), quiet_(quiet) {}

ProgressBars::~ProgressBars() { finish(); }

void ProgressBars::log(LogLevel level, const std::string& stage, const std::string& sentence) {
  if (level == LogLevel::kDebug || (quiet_ && level != LogLevel::kWarning)) return;
  const std::lock_guard lock(mutex_);
  erase();
  const char* mark = level == LogLevel::kWarning ? "warning: " : "";
  fmt::print(stderr, "{}{}{}{}\n", stage, stage.empty() ? "" : ": ", mark, sentence);
  std::fputs(drawn_.c_str(), stderr);
  lines_drawn_ = static_cast<int>(std::count(drawn_.begin(), drawn_.end(), '\n'));
  std::fflush(stderr);
}

void ProgressBars::show(const RunProgress& progress) {
  if (!terminal_ || quiet_) return;
  const std::lock_guard lock(mutex_);
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
  std::size_t name_width = 0;
  for (const auto& process : progress.processes)
    name_width = std::max(name_width, process.name.size());
  drawn_.clear();
  for (const auto& process : progress.processes)
    drawn_ += progress_line(process, seconds, name_width) + "\n";
  erase();
  std::fputs(drawn_.c_str(), stderr);
  std::fflush(stderr);
  lines_drawn_ = static_cast<int>(progress.processes.size());
}

void ProgressBars::finish() {
  const std::lock_guard lock(mutex_);
  erase();
  drawn_.clear();
  std::fflush(stderr);
}

void ProgressBars::erase() {
  if (lines_drawn_ > 0) fmt::print(stderr, "\x1b[{}A\x1b[0J", lines_drawn_);
  lines_drawn_ = 0;
}

}  // namespace stope
