#pragma once

#include <condition_variable>
#include <cstddef>
#include <functional>
#include <memory>
#include <mutex>

#include "framework/executor/tbb_arena.hpp"

namespace stope {

/// Something for a oneTBB worker to do.
class PoolTask {
 public:
  virtual ~PoolTask() = default;
  virtual void run() noexcept = 0;
};

/// The oneTBB workers of a run. They also serve the parallel loops inside stages.
class WorkerPool {
 public:
  /// `threads` workers; 0: as many as the machine has processors.
  explicit WorkerPool(int threads);
  /// Waits for the tasks that are left.
  ~WorkerPool();
  WorkerPool(const WorkerPool&) = delete;
  WorkerPool& operator=(const WorkerPool&) = delete;

  int threads() const { return threads_; }
  /// Runs the task once on some worker. Tasks begin in the order in which they came.
  void enqueue(std::shared_ptr<PoolTask> task);

  /// Runs `work` here. Should it wait for parallel work of its own, this thread takes no other task
  /// meanwhile: one that needs what `work` is about to give would wait for itself.
  static void run_isolated(const std::function<void()>& work);

 private:
  struct Ticket;
  static void run_ticket(void* ticket);
  void finished();

  int threads_;
  std::mutex mutex_;
  std::condition_variable idle_;
  std::size_t tasks_ = 0;
  TbbArena arena_;
};

}  // namespace stope
