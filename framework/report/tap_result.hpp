#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "framework/pipeline/plan.hpp"
#include "framework/report/sketch.hpp"

namespace stope::report {

/// What a tap saw at an output of a stage. It may be kept on the disk, without its place.
struct TapResult {
  PlannedSource source;
  std::uint64_t items = 0;
  std::string digest;  ///< 32 hexadecimal digits, or empty
  std::vector<Sketch> sketches;
  static constexpr void fields(auto& s, auto&& visit) {
    visit("items", s.items);
    visit("digest", s.digest);
    visit("sketches", s.sketches);
  }
};

}  // namespace stope::report
