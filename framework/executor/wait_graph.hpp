#pragma once

#include <cstddef>
#include <mutex>

namespace stope {

class Channel;
class Process;

/// Who waits for whom, and the way out of artificial deadlocks.
///
/// A process that cannot go on waits for exactly one other: the writer of an empty channel or the
/// reader of a full one. So the waits form chains, and a deadlock is a chain that bites its tail,
/// whether or not the rest of the network still runs. In a network without cycles of channels, such
/// a cycle of waits holds at least one full channel: with more room the deadlock would not be
/// there. The smallest of them doubles (Parks, Bounded Scheduling of Process Networks, 1995). A
/// cycle is found by the process whose wait closes it, by walking the chain: as many steps as there
/// are processes at most, and only when a process is about to sleep anyway.
class WaitGraph {
 public:
  explicit WaitGraph(std::size_t processes) : processes_(processes) {}
  /// Notes that `process` waits at `channel`, as its reader or its writer. If that closes a cycle
  /// of waits, grows the cycle's smallest full channel and wakes its writer, which may be `process`
  /// itself.
  void enter(Process& process, Channel& channel);
  /// Notes that `process` waits no more.
  static void leave(Process& process);

 private:
  std::size_t processes_;
  std::mutex mutex_;
};

}  // namespace stope
