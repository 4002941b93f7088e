// What a comparison costs beside its parts, and what is lost when it is killed.
#include <cstdio>
#include <cstdlib>
#include <string>

#include "tests/benchmarks/comparing/killed_comparisons.hpp"
#include "tests/benchmarks/comparing/shared_prefix.hpp"

int main(int argc, char** argv) {
  // Hours of figures must not be lost in a buffer if it is stopped.
  std::setvbuf(stdout, nullptr, _IOLBF, 0);
  const std::string part = argc > 1 ? argv[1] : "all";
  const int times = argc > 2 ? std::atoi(argv[2]) : 0;
  bool good = true;
  if (part == "all" || part == "prefix")
    good = stope::benchmark::compare_shared_prefixes(times > 0 ? times : 5) && good;
  if (part == "all" || part == "kill")
    good = stope::benchmark::kill_comparisons(times > 0 ? times : 20) && good;
  return good ? 0 : 1;
}
