#pragma once

#include <cstdint>
#include <string>

#include "stope/time.hpp"

namespace stope {

/// `1.250 s`, exact to the nanosecond, at least three decimals.
std::string time_text(Stamp stamp);

/// `item 3 (1.250 s)`, as messages name an item.
std::string item_text(std::uint64_t index, Stamp stamp);

}  // namespace stope
