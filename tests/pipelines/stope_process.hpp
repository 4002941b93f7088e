#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace stope::testing {

/// How the command ended and what it printed.
struct ProcessResult {
  int exit_code = -1;  ///< 128 + signal if a signal ended it
  std::string out, err;
};

/// A stope command that may still be running.
class StopeProcess {
 public:
  /// Starts `stope arguments…` (the build's own) with `environment` added to this process's.
  explicit StopeProcess(const std::vector<std::string>& arguments,
                        const std::map<std::string, std::string>& environment = {});
  ~StopeProcess();
  StopeProcess(const StopeProcess&) = delete;
  StopeProcess& operator=(const StopeProcess&) = delete;
  void send_signal(int signal) const;
  /// Waits for its end.
  ProcessResult wait();

 private:
  int pid_ = -1;
  std::filesystem::path out_, err_;
};

/// Runs `stope arguments…` to its end.
ProcessResult stope(const std::vector<std::string>& arguments,
                    const std::map<std::string, std::string>& environment = {});

/// A folder of a test's own, removed with it.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// The source tree's file of this name, such as `pipelines/quickstart.yaml`.
std::string shipped(const std::string& name);

std::string read_file(const std::filesystem::path& file);
void write_file(const std::filesystem::path& file, const std::string& text);

/// sha256 by output path, from a run's run.json.
std::map<std::string, std::string> output_digests(const std::filesystem::path& run_folder);

/// The folder of real data, or an empty path: tests that need it skip then.
std::filesystem::path data_folder();

}  // namespace stope::testing
