// This file is compiled without ThreadSanitizer.
#include "framework/executor/tbb_arena.hpp"

#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <cstddef>

namespace stope {

struct TbbArena::Parts {
  explicit Parts(int workers)
      // One more than there are workers: the limit counts the thread that waits for them as well.
      : limit(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(workers) + 1),
        arena(workers, 0) {}
  tbb::global_control limit;
  tbb::task_arena arena;
};

TbbArena::TbbArena(int workers) : parts_(std::make_unique<Parts>(workers)) {}

TbbArena::~TbbArena() = default;

void TbbArena::enqueue(void (*run)(void*), void* argument) {
  parts_->arena.enqueue([run, argument] { run(argument); });
}

void TbbArena::isolate(void (*run)(void*), void* argument) {
  tbb::this_task_arena::isolate([run, argument] { run(argument); });
}

}  // namespace stope
