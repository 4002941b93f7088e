#pragma once

#include <cstddef>

#include "framework/cli/arguments.hpp"

namespace stope {

/// Workers for parallel work: as told, else as many as the machine has.
int threads_of(const Arguments& arguments);

/// Bytes for the whole process: as told, else half of RAM.
std::size_t memory_of(const Arguments& arguments);

}  // namespace stope
