#pragma once

#include <cstdlib>
#include <string>

#include "stope/random.hpp"

namespace stope::testing {

/// What copying, editing and disks do to files: bits flip, bytes are lost, doubled, overwritten by
/// digits and brackets, and the end is cut off.
inline std::string damaged(std::string bytes, Random& random) {
  static constexpr char kLikely[] = "0129-.eE{}[]\",: \n\t\\#&*!|>'%@~n\xff\x80";
  const auto place = [&] { return bytes.empty() ? 0 : random.below(bytes.size()); };
  const std::uint64_t wounds = 1 + random.below(4);
  for (std::uint64_t i = 0; i < wounds && !bytes.empty(); ++i) {
    const std::size_t at = place();
    switch (random.below(7)) {
      case 0:
        bytes[at] = static_cast<char>(bytes[at] ^ (1 << random.below(8)));
        break;
      case 1:
        bytes[at] = kLikely[random.below(sizeof(kLikely) - 1)];
        break;
      case 2:
        bytes.insert(at, 1, kLikely[random.below(sizeof(kLikely) - 1)]);
        break;
      case 3:
        bytes.erase(at, 1 + random.below(8));
        break;
      case 4:
        bytes.insert(at, bytes.substr(at, 1 + random.below(40)));
        break;
      case 5:
        bytes.insert(at, std::string(1 + random.below(12), '9'));
        break;
      default:
        if (random.below(4) == 0) bytes.resize(at);
        break;
    }
  }
  return bytes;
}

/// How many damaged files a test looks at: STOPE_DAMAGED_FILES, or few enough for every day.
inline int damaged_files(int usual) {
  const char* text = std::getenv("STOPE_DAMAGED_FILES");
  return text ? std::atoi(text) : usual;
}

}  // namespace stope::testing
