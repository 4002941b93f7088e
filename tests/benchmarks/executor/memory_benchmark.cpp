// The memory budget held against the kernel's high-water mark: recordings ten times larger than the
// budget, read twice, lazy and derived, of small and of large payloads, on 1, 2 and 8 threads. Each
// case is a process of its own (memory_child). Prints VmHWM as a part of the budget; at most 1.10
// is allowed. The argument is the budget in MiB (default 256).
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <memory>
#include <sstream>
#include <string>

namespace {

std::string output_of(const std::string& command) {
  const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen(command.c_str(), "r"), &pclose);
  std::string text;
  char piece[256];
  while (pipe && std::fgets(piece, sizeof(piece), pipe.get())) text += piece;
  return text;
}

}  // namespace

int main(int count, char** arguments) {
  const std::string child =
      (std::filesystem::read_symlink("/proc/self/exe").parent_path() / "memory_child").string();
  const int budget = count > 1 ? std::atoi(arguments[1]) : 256;
  bool fine = true;
  std::cout << "kind     payload  threads   VmHWM / budget   seconds   loaded  spilled\n";
  for (const char* kind : {"lazy", "derived"}) {
    for (const int bytes : {40'000, 2'000'000}) {
      for (const int threads : {1, 2, 8}) {
        std::ostringstream command;
        command << child << ' ' << kind << ' ' << bytes << ' ' << threads << ' ' << budget << ' '
                << 10 * budget;
        std::istringstream result(output_of(command.str()));
        double ratio = 0, seconds = 0;
        long loaded = 0, spilled = 0;
        if (!(result >> ratio >> seconds >> loaded >> spilled) || ratio > 1.10) fine = false;
        std::printf("%-8s %7d %8d %16.3f %9.1f %8ld %8ld\n", kind, bytes, threads, ratio, seconds,
                    loaded, spilled);
        std::fflush(stdout);
      }
    }
  }
  return fine ? 0 : 1;
}
