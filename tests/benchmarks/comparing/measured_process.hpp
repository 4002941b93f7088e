#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace stope::benchmark {

/// How a command ended.
struct MeasuredProcess {
  int exit_code = 0;     ///< 128 + signal if a signal ended it
  double wall = 0;       ///< seconds
  double processor = 0;  ///< seconds of all its threads, also if it was killed
};

/// Runs `stope arguments…`, silently. `kill_after`: seconds of processor time after which it is
/// killed, as by a power cut, if it still runs. That is how far it has got, however busy the
/// machine is.
MeasuredProcess run_stope(const std::vector<std::string>& arguments,
                          std::optional<double> kill_after = {});

/// A folder that is removed in the end.
class WorkFolder {
 public:
  WorkFolder();
  ~WorkFolder();
  WorkFolder(const WorkFolder&) = delete;
  WorkFolder& operator=(const WorkFolder&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

std::string text_of(const std::filesystem::path& file);
void write_text(const std::filesystem::path& file, const std::string& text);

double median(std::vector<double> values);

}  // namespace stope::benchmark
