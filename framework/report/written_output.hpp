#pragma once

#include <cstdint>
#include <string>

namespace stope::report {

/// A file that a run left under outputs/.
struct WrittenFile {
  std::string output;  ///< the entry under `outputs:` it belongs to, as written there
  std::string path;    ///< relative to the run directory: `outputs/map.pgm`
  std::uint64_t bytes = 0;
  std::string sha256;
  bool companion = false;  ///< not the file the pipeline asked for but one that belongs to it
};

}  // namespace stope::report
