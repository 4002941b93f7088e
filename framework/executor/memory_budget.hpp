#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "framework/executor/resident_size.hpp"
#include "framework/executor/run_record.hpp"
#include "framework/executor/shelf.hpp"
#include "framework/executor/spill_files.hpp"

namespace stope {

/// Keeps the whole process within its memory by evicting payloads.
///
/// A sum of payload sizes misses what stages use for themselves and what malloc keeps, so the
/// resident size of the process is measured, each time some more bytes of payloads have come into
/// memory. Above the upper mark, what must go to reach the lower mark becomes a debt, which every
/// thread that brings in more bytes helps to pay off. Nobody waits: if there is nothing left to
/// evict, the process runs over. Cost: an atomic addition for each payload, a microsecond for each
/// measure.
class MemoryBudget {
 public:
  /// `limit` in bytes, 0 for half of the machine's. `disk_failed` is told, once, that payloads
  /// cannot be spilled.
  MemoryBudget(std::size_t limit, ScratchFolder& scratch,
               std::function<void(const std::string&)> disk_failed);

  std::size_t limit() const { return limit_; }
  /// One for each output. Before the run begins.
  Shelf& add_shelf();

  /// Some bytes of payload have come into memory or are about to.
  void make_room(std::size_t bytes);
  /// Measures, whatever came in. For a thread that looks in now and then: stages use memory too.
  void look();
  /// The run is over: evicts nothing from here on. Payloads may live longer.
  void close() { closed_.store(true); }

  /// What payloads report of themselves.
  void freed(std::size_t bytes);
  void loaded() { loaded_.fetch_add(1, std::memory_order_relaxed); }
  void evicted() { evicted_.fetch_add(1, std::memory_order_relaxed); }
  void spilled(std::size_t bytes);

  void record(RunRecord& record) const;

 private:
  void measure();
  void pay();
  /// Evicts the payload that is needed last. Gives the bytes freed; none if there is no payload
  /// left to try.
  std::optional<std::size_t> evict_furthest();

  ResidentSize resident_;
  std::size_t limit_, upper_, lower_, step_;
  SpillFiles files_;
  std::function<void(const std::string&)> disk_failed_;
  std::vector<std::unique_ptr<Shelf>> shelves_;
  std::atomic<bool> closed_{false};
  std::mutex measuring_;
  std::atomic<std::size_t> fresh_{0};           ///< bytes that came in since the last measure
  std::atomic<std::size_t> kept_by_malloc_{0};  ///< bytes freed, perhaps not to the kernel
  std::atomic<std::int64_t> debt_{0};
  std::atomic<std::uint64_t> round_{0};
  std::atomic<std::uint64_t> loaded_{0}, evicted_{0}, spilled_{0}, bytes_spilled_{0};
};

}  // namespace stope
