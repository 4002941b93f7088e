#include "tests/benchmarks/comparing/measured_process.hpp"

#include <fcntl.h>
#include <signal.h>
#include <stdlib.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <thread>

namespace stope::benchmark {
namespace {

using Clock = std::chrono::steady_clock;

double seconds(const timeval& time) {
  return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_usec) * 1e-6;
}

[[noreturn]] void become_stope(const std::vector<std::string>& arguments) {
  const int nothing = ::open("/dev/null", O_WRONLY);
  ::dup2(nothing, STDOUT_FILENO);
  std::vector<char*> words{const_cast<char*>(STOPE_EXECUTABLE)};
  for (const std::string& word : arguments) words.push_back(const_cast<char*>(word.c_str()));
  words.push_back(nullptr);
  ::execv(STOPE_EXECUTABLE, words.data());
  ::_exit(127);
}

/// Of all threads of a process that has not been waited for.
double processor_seconds(pid_t child) {
  const std::string stat = text_of("/proc/" + std::to_string(child) + "/stat");
  // The name of the program, in brackets, may hold blanks.
  std::istringstream fields(stat.substr(std::min(stat.size(), stat.rfind(')') + 1)));
  std::string skipped;
  for (int i = 0; i < 11; ++i) fields >> skipped;
  double user = 0, system = 0;
  fields >> user >> system;
  return (user + system) / static_cast<double>(::sysconf(_SC_CLK_TCK));
}

bool runs(pid_t child) {
  siginfo_t ended{};
  ::waitid(P_PID, static_cast<id_t>(child), &ended, WEXITED | WNOHANG | WNOWAIT);
  return ended.si_pid == 0;
}

}  // namespace

MeasuredProcess run_stope(const std::vector<std::string>& arguments,
                          std::optional<double> kill_after) {
  const auto begin = Clock::now();
  const pid_t child = ::fork();
  if (child < 0) throw std::runtime_error("cannot fork");
  if (child == 0) become_stope(arguments);
  int status = 0;
  rusage used{};
  if (kill_after) {
    while (runs(child) && processor_seconds(child) < *kill_after)
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    ::kill(child, SIGKILL);
  }
  ::wait4(child, &status, 0, &used);
  MeasuredProcess ended;
  ended.wall = std::chrono::duration<double>(Clock::now() - begin).count();
  ended.processor = seconds(used.ru_utime) + seconds(used.ru_stime);
  ended.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return ended;
}

WorkFolder::WorkFolder() {
  std::string name = (std::filesystem::temp_directory_path() / "stope-bench-XXXXXX").string();
  if (!::mkdtemp(name.data())) throw std::runtime_error("cannot make " + name);
  path_ = name;
}

WorkFolder::~WorkFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

std::string text_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

void write_text(const std::filesystem::path& file, const std::string& text) {
  std::ofstream(file, std::ios::binary) << text;
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2;
}

}  // namespace stope::benchmark
