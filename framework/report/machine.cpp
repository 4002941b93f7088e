#include "framework/report/machine.hpp"

#ifdef __GLIBC__
#include <gnu/libc-version.h>
#endif
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

std::vector<std::string> features_of_processor() {
  std::vector<std::string> features;
#if defined(__x86_64__) || defined(__i386__)
  const auto note = [&](const char* name, int supported) {
    if (supported) features.emplace_back(name);
  };
  note("sse4.2", __builtin_cpu_supports("sse4.2"));
  note("avx", __builtin_cpu_supports("avx"));
  note("avx2", __builtin_cpu_supports("avx2"));
  note("fma", __builtin_cpu_supports("fma"));
  note("avx512f", __builtin_cpu_supports("avx512f"));
#endif
  return features;
}

}  // namespace

Machine this_machine() {
  Machine machine;
  machine.features = features_of_processor();
#ifdef __GLIBC__
  machine.libraries = std::string("glibc ") + ::gnu_get_libc_version();
#endif
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
