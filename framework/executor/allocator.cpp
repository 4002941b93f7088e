#include "framework/executor/allocator.hpp"

#include <malloc.h>

namespace stope {

void set_allocator_up() {
  mallopt(M_MMAP_THRESHOLD, static_cast<int>(kOwnMappingFrom));
  mallopt(M_TRIM_THRESHOLD, 4 << 20);
  mallopt(M_ARENA_MAX, 4);
}

void return_free_memory() { malloc_trim(0); }

}  // namespace stope
