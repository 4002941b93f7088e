// This file is compiled without ThreadSanitizer: see task_handoff.hpp.
#include "framework/executor/worker_pool.hpp"

#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <condition_variable>
#include <mutex>
#include <thread>
#include <utility>

#include "framework/executor/task_handoff.hpp"

namespace stope {

struct WorkerPool::Arena {
  explicit Arena(int threads)
      // One more than there are workers: the limit counts the thread that waits for them as well.
      : limit(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads) + 1),
        arena(threads, 0) {}
  tbb::global_control limit;
  tbb::task_arena arena;
  std::mutex mutex;
  std::condition_variable idle;
  std::size_t tasks = 0;
};

WorkerPool::WorkerPool(int threads)
    : threads_(threads > 0 ? threads
                           : std::max(1, static_cast<int>(std::thread::hardware_concurrency()))),
      arena_(std::make_unique<Arena>(threads_)) {}

WorkerPool::~WorkerPool() {
  std::unique_lock lock(arena_->mutex);
  arena_->idle.wait(lock, [&] { return arena_->tasks == 0; });
}

void WorkerPool::enqueue(std::shared_ptr<PoolTask> task) {
  {
    const std::lock_guard lock(arena_->mutex);
    ++arena_->tasks;
  }
  hand_over(task.get());
  arena_->arena.enqueue([arena = arena_.get(), task = std::move(task)] {
    take_over(task.get());
    task->run();
    hand_over(task.get());
    const std::lock_guard lock(arena->mutex);
    if (--arena->tasks == 0) arena->idle.notify_all();
  });
}

void WorkerPool::run_isolated(const std::function<void()>& work) {
  tbb::this_task_arena::isolate([&] { work(); });
}

}  // namespace stope
