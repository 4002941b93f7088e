#include "framework/report/run_log.hpp"

#include <fmt/format.h>

#include "stope/error.hpp"

namespace stope::report {
namespace {

constexpr std::size_t kWarningsKept = 200, kLinesKept = 60;

const char* name_of(LogLevel level) {
  switch (level) {
    case LogLevel::kDebug:
      return "debug  ";
    case LogLevel::kInfo:
      return "info   ";
    case LogLevel::kWarning:
      return "warning";
  }
  return "";
}

// A sentence with a line break must not look like two lines of the log.
std::string on_one_line(std::string_view text) {
  std::string line(text);
  for (char& c : line) {
    if (c == '\n' || c == '\r') c = ' ';
  }
  return line;
}

}  // namespace

RunLog::RunLog(const std::filesystem::path& file) : file_(file) {}

void RunLog::add(LogLevel level, std::string_view stage, std::string_view sentence) {
  const std::lock_guard lock(mutex_);
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begin_;
  const LogLine line{elapsed.count(), level, std::string(stage), on_one_line(sentence)};
  if (failure_.empty()) {
    try {
      file_.write(fmt::format("{:10.3f} s  {}  {}{}{}\n", line.seconds, name_of(level), line.stage,
                              line.stage.empty() ? "" : ": ", line.sentence));
      file_.flush();
    } catch (const Error& error) {
      failure_ = error.what();
    }
  }
  if (level == LogLevel::kWarning && ++warning_count_ <= kWarningsKept) warnings_.push_back(line);
  if (level == LogLevel::kDebug) return;
  if (recent_.size() < kLinesKept) {
    recent_.push_back(line);
  } else {
    recent_[line_count_ % kLinesKept] = line;
  }
  ++line_count_;
}

void RunLog::close() {
  const std::lock_guard lock(mutex_);
  if (!failure_.empty()) throw Error(failure_);
  file_.close();
}

std::vector<LogLine> RunLog::last_lines() const {
  std::vector<LogLine> lines;
  for (std::size_t i = 0; i < recent_.size(); ++i)
    lines.push_back(recent_[recent_.size() < kLinesKept ? i : (line_count_ + i) % kLinesKept]);
  return lines;
}

}  // namespace stope::report
