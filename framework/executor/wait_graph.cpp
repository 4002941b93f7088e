#include "framework/executor/wait_graph.hpp"

#include "framework/executor/channel.hpp"
#include "framework/executor/process.hpp"

namespace stope {

namespace {

/// Whether a wait noted earlier still holds: its process may have been rung and not have run since.
bool holds(const Process& process, const Channel& channel) {
  return &channel.reader() == &process ? !channel.readable() : !channel.writable();
}

Process& other_side(const Process& process, const Channel& channel) {
  return &channel.reader() == &process ? channel.writer() : channel.reader();
}

}  // namespace

void WaitGraph::enter(Process& process, Channel& channel) {
  // Nobody can begin to wait while the lock is held. A process that is seen waiting below can go on
  // only if the one it waits for acts, so what is seen of a whole cycle is true at one moment.
  const std::lock_guard lock(mutex_);
  process.waits_at().store(&channel);
  Channel* smallest = nullptr;
  const Process* walker = &process;
  for (std::size_t steps = 0; steps == 0 || walker != &process; ++steps) {
    // A cycle further down the chain was resolved when it arose; its processes are about to wake.
    if (steps > processes_) return;
    Channel* const at = walker->waits_at().load();
    if (!at || !holds(*walker, *at)) return;
    // It may have woken, read and emptied the channel again between the two looks.
    if (walker->waits_at().load() != at) return;
    const bool full = &at->writer() == walker;
    if (full && (!smallest || at->capacity() < smallest->capacity())) smallest = at;
    walker = &other_side(*walker, *at);
  }
  if (smallest) smallest->grow();
}

void WaitGraph::leave(Process& process) { process.waits_at().store(nullptr); }

}  // namespace stope
