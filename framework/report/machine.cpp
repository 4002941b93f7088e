#include "framework/report/machine.hpp"

#include <sched.h>
#include <sys/utsname.h>
#include <unistd.h>

#include <fstream>
#include <string_view>

namespace stope::report {
namespace {

// The value of the first line `key<separator>value` of a file.
std::string value_in(const char* file, std::string_view key, char separator) {
  std::ifstream stream(file);
  for (std::string line; std::getline(stream, line);) {
    if (!line.starts_with(key)) continue;
    const std::size_t split = line.find(separator);
    if (split == std::string::npos) continue;
    std::string value = line.substr(split + 1);
    const std::size_t begin = value.find_first_not_of(" \t\"");
    const std::size_t end = value.find_last_not_of(" \t\"");
    if (begin != std::string::npos) return value.substr(begin, end - begin + 1);
  }
  return {};
}

}  // namespace

Machine this_machine() {
  Machine machine;
  machine.processor = value_in("/proc/cpuinfo", "model name", ':');
  cpu_set_t cpus;
  if (::sched_getaffinity(0, sizeof(cpus), &cpus) == 0) machine.cores = CPU_COUNT(&cpus);
  const long pages = ::sysconf(_SC_PHYS_PAGES), page = ::sysconf(_SC_PAGE_SIZE);
  if (pages > 0 && page > 0)
    machine.memory = static_cast<std::uint64_t>(pages) * static_cast<std::uint64_t>(page);
  machine.system = value_in("/etc/os-release", "PRETTY_NAME", '=');
  utsname name{};
  if (::uname(&name) == 0) {
    machine.host = name.nodename;
    if (machine.processor.empty()) machine.processor = name.machine;
    machine.system +=
        (machine.system.empty() ? "" : ", ") + std::string(name.sysname) + " " + name.release;
  }
  return machine;
}

}  // namespace stope::report
