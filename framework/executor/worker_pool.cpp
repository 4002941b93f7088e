#include "framework/executor/worker_pool.hpp"

#include <algorithm>
#include <thread>
#include <utility>

#include "framework/executor/task_handoff.hpp"

namespace stope {

/// A task on its way through oneTBB.
struct WorkerPool::Ticket {
  WorkerPool& pool;
  std::shared_ptr<PoolTask> task;
};

WorkerPool::WorkerPool(int threads)
    : threads_(threads > 0 ? threads
                           : std::max(1, static_cast<int>(std::thread::hardware_concurrency()))),
      arena_(threads_) {}

WorkerPool::~WorkerPool() {
  std::unique_lock lock(mutex_);
  idle_.wait(lock, [&] { return tasks_ == 0; });
}

void WorkerPool::enqueue(std::shared_ptr<PoolTask> task) {
  auto ticket = std::make_unique<Ticket>(Ticket{*this, std::move(task)});
  {
    const std::lock_guard lock(mutex_);
    ++tasks_;
  }
  hand_over(ticket.get());
  // Owned by oneTBB until run_ticket() takes it back.
  arena_.enqueue(&WorkerPool::run_ticket, ticket.release());
}

void WorkerPool::run_ticket(void* pointer) {
  take_over(pointer);
  std::unique_ptr<Ticket> ticket(static_cast<Ticket*>(pointer));
  WorkerPool& pool = ticket->pool;
  ticket->task->run();
  ticket.reset();
  pool.finished();
}

void WorkerPool::finished() {
  const std::lock_guard lock(mutex_);
  if (--tasks_ == 0) idle_.notify_all();
}

void WorkerPool::run_isolated(const std::function<void()>& work) {
  TbbArena::isolate([](void* pointer) { (*static_cast<const std::function<void()>*>(pointer))(); },
                    const_cast<std::function<void()>*>(&work));
}

}  // namespace stope
