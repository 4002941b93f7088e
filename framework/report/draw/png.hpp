#pragma once

#include <cstdint>
#include <vector>

#include "framework/report/picture.hpp"

namespace stope::report {

/// A picture as a PNG file: a palette where 256 colours suffice, else RGBA. The same picture gives
/// the same bytes.
std::vector<std::uint8_t> encode_png(const Picture& picture);

}  // namespace stope::report
