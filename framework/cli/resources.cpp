#include "framework/cli/resources.hpp"

#include <unistd.h>

#include <thread>

namespace stope {

int threads_of(const Arguments& arguments) {
  return arguments.threads > 0 ? arguments.threads
                               : static_cast<int>(std::thread::hardware_concurrency());
}

std::size_t memory_of(const Arguments& arguments) {
  if (arguments.memory > 0) return arguments.memory;
  return static_cast<std::size_t>(::sysconf(_SC_PHYS_PAGES)) *
         static_cast<std::size_t>(::sysconf(_SC_PAGESIZE)) / 2;
}

}  // namespace stope
