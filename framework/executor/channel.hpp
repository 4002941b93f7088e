#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <string>

#include "framework/executor/doorbell.hpp"
#include "framework/executor/item_queue.hpp"
#include "framework/executor/run_record.hpp"

namespace stope {

class Process;

/// One edge of the network: what one process writes and one other reads, in order, at most
/// `capacity` items at a time.
///
/// Neither side locks. Each side says when it waits here; the other then rings its doorbell. A
/// waiting writer is rung when the channel is half empty rather than at the first free place, and
/// at the latest before its reader waits for anything itself: one wake-up serves many items.
class Channel {
 public:
  Channel(std::string from, std::string to, std::size_t capacity, Process& writer, Process& reader);

  Process& writer() const { return writer_; }
  Process& reader() const { return reader_; }
  std::size_t capacity() const { return capacity_.load(); }
  bool empty() const { return queue_.size() == 0; }
  bool full() const { return queue_.size() >= capacity(); }
  /// Items read so far.
  std::uint64_t items_read() const { return queue_.read(); }

  /// Of the reader: whether it need not wait.
  bool readable() const { return !empty() || closed_.load(); }
  /// Of the writer: whether it need not wait.
  bool writable() const { return !full() || abandoned_.load(); }

  /// Of the writer: adds an item. There must be room. Dropped if the reader has left.
  void push(AnyItem item);
  /// Of the writer: there will be no more items.
  void close();
  /// Of the writer: it failed, or could not go on, so that items are missing behind the last.
  void break_off();
  bool closed() const { return closed_.load(); }
  /// Of a closed channel: whether it was broken off.
  bool broken() const { return broken_.load(); }
  /// Whether the reader has left; what is written is dropped from then on.
  bool abandoned() const { return abandoned_.load(); }

  /// Of the reader: the next item, or an empty one if the channel is empty.
  AnyItem pop();
  /// Of the reader: it will read no more.
  void abandon();
  /// Of the reader, before it waits for anything: wakes a writer that waits for the channel to be
  /// half empty.
  void wake_writer();

  /// Says that a side is about to wait, or does not wait any more.
  void set_reader_waits(bool waits) { reader_waits_.store(waits); }
  void set_writer_waits(bool waits) { writer_waits_.store(waits); }

  /// Doubles the capacity. Resolves an artificial deadlock.
  void grow();

  ChannelRecord record() const;

 private:
  ItemQueue queue_;
  std::atomic<std::size_t> capacity_;
  std::atomic<bool> reader_waits_{false}, writer_waits_{false};
  std::atomic<bool> closed_{false}, broken_{false}, abandoned_{false};
  std::atomic<std::uint32_t> growths_{0};
  Process& writer_;
  Process& reader_;
  Doorbell& writer_bell_;
  Doorbell& reader_bell_;
  std::string from_, to_;
};

}  // namespace stope
