#pragma once

#include <atomic>
#include <cstdint>

#include "framework/executor/channel.hpp"
#include "stope/ports.hpp"

namespace stope {

/// A process's end of an input: reads a channel, or nothing where none is wired.
class InputEnd final : public InputPort {
 public:
  explicit InputEnd(Process& process) : process_(process) {}
  void wire(Channel& channel, bool stream) { channel_ = &channel, stream_ = stream; }

  bool wired() const { return channel_ != nullptr; }
  /// Whether what feeds it is a stream (else a value).
  bool stream() const { return stream_; }
  Channel* channel() const { return channel_; }

  AnyItem next() override;
  /// The next item if there is one now. Not after ended().
  AnyItem try_next();
  /// Whether all items have been read and no more will come. Once true, it stays so.
  bool ended() const { return !channel_ || (channel_->closed() && channel_->empty()); }
  /// Once it has ended: lets the process end, too, if its writer failed and items are missing.
  void require_whole() const;

  /// The process reads no more.
  void leave();
  std::uint64_t items() const { return items_.load(std::memory_order_relaxed); }

 private:
  Process& process_;
  Channel* channel_ = nullptr;
  bool stream_ = false;
  std::atomic<std::uint64_t> items_{0};
};

}  // namespace stope
