#pragma once

#include <cstddef>

namespace stope {

/// Blocks from this size on come from the kernel and go back to it when freed.
inline constexpr std::size_t kOwnMappingFrom = 128 * 1024;

/// Sets malloc up so that memory that was freed can be given back to the kernel: by default it
/// learns from large blocks to keep ever larger ones, and what a run measures of itself would no
/// longer say what it uses. Holds for the whole process.
void set_allocator_up();

/// Gives free memory back to the kernel. Takes time in proportion to how scattered it is.
void return_free_memory();

}  // namespace stope
