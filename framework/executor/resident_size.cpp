#include "framework/executor/resident_size.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cstdlib>
#include <cstring>
#include <fstream>
#include <string>

namespace stope {

ResidentSize::ResidentSize()
    : statm_(open("/proc/self/statm", O_RDONLY | O_CLOEXEC)),
      page_(static_cast<std::size_t>(sysconf(_SC_PAGESIZE))) {}

ResidentSize::~ResidentSize() {
  if (statm_ >= 0) close(statm_);
}

std::size_t ResidentSize::measure() const {
  char text[128];
  const ssize_t size = pread(statm_, text, sizeof(text) - 1, 0);
  if (size <= 0) return 0;
  text[size] = '\0';
  const char* const second = std::strchr(text, ' ');
  return second ? std::strtoull(second, nullptr, 10) * page_ : 0;
}

std::size_t ResidentSize::peak() {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);) {
    if (line.rfind("VmHWM:", 0) == 0) return std::strtoull(line.c_str() + 6, nullptr, 10) * 1024;
  }
  return 0;
}

std::size_t ResidentSize::of_machine() {
  return static_cast<std::size_t>(sysconf(_SC_PHYS_PAGES)) *
         static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}

}  // namespace stope
