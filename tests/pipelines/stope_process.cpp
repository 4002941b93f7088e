#include "stope_process.hpp"

#include <fcntl.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>

namespace stope::testing {
namespace {

std::filesystem::path temporary_file() {
  std::string name = (std::filesystem::temp_directory_path() / "stope-output-XXXXXX").string();
  const int file = ::mkstemp(name.data());
  if (file < 0) throw std::runtime_error("cannot make a temporary file");
  ::close(file);
  return name;
}

[[noreturn]] void become_stope(const std::vector<std::string>& arguments,
                               const std::map<std::string, std::string>& environment,
                               const std::string& out, const std::string& err) {
  // Tests neither find nor leave results in the store of who runs them.
  ::setenv("STOPE_CACHE", "off", 1);
  for (const auto& [name, value] : environment) ::setenv(name.c_str(), value.c_str(), 1);
  ::dup2(::open(out.c_str(), O_WRONLY | O_TRUNC), STDOUT_FILENO);
  ::dup2(::open(err.c_str(), O_WRONLY | O_TRUNC), STDERR_FILENO);
  std::vector<std::string> words{STOPE_EXECUTABLE};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  pointers.reserve(words.size() + 1);
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  ::execv(STOPE_EXECUTABLE, pointers.data());
  ::_exit(127);
}

}  // namespace

StopeProcess::StopeProcess(const std::vector<std::string>& arguments,
                           const std::map<std::string, std::string>& environment)
    : out_(temporary_file()), err_(temporary_file()) {
  const std::string out = out_.string(), err = err_.string();
  pid_ = ::fork();
  if (pid_ < 0) throw std::runtime_error("cannot start a process");
  if (pid_ == 0) become_stope(arguments, environment, out, err);
}

StopeProcess::~StopeProcess() {
  if (pid_ > 0) {
    ::kill(pid_, SIGKILL);
    ::waitpid(pid_, nullptr, 0);
  }
  std::error_code ignored;
  std::filesystem::remove(out_, ignored);
  std::filesystem::remove(err_, ignored);
}

void StopeProcess::send_signal(int signal) const { ::kill(pid_, signal); }

ProcessResult StopeProcess::wait() {
  int status = 0;
  ::waitpid(pid_, &status, 0);
  pid_ = -1;
  ProcessResult result;
  result.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  result.out = read_file(out_);
  result.err = read_file(err_);
  return result;
}

ProcessResult stope(const std::vector<std::string>& arguments,
                    const std::map<std::string, std::string>& environment) {
  return StopeProcess(arguments, environment).wait();
}

TemporaryFolder::TemporaryFolder() {
  std::string name = (std::filesystem::temp_directory_path() / "stope-run-XXXXXX").string();
  if (!::mkdtemp(name.data())) throw std::runtime_error("cannot make a temporary folder");
  path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

std::string shipped(const std::string& name) { return std::string(STOPE_SOURCE_DIR) + "/" + name; }

std::string read_file(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

void write_file(const std::filesystem::path& file, const std::string& text) {
  std::filesystem::create_directories(file.parent_path());
  std::ofstream(file, std::ios::binary) << text;
}

std::map<std::string, std::string> output_digests(const std::filesystem::path& run_folder) {
  std::map<std::string, std::string> digests;
  const auto record = nlohmann::json::parse(read_file(run_folder / "run.json"));
  for (const auto& output : record.at("outputs")) digests[output.at("path")] = output.at("sha256");
  return digests;
}

std::filesystem::path data_folder() {
  const char* given = std::getenv("STOPE_DATA");
  const std::filesystem::path folder =
      given ? given : std::string(STOPE_SOURCE_DIR) + "/../shared/data";
  return std::filesystem::is_directory(folder) ? folder : std::filesystem::path();
}

}  // namespace stope::testing
