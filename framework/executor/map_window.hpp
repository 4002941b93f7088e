#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "framework/executor/doorbell.hpp"
#include "framework/executor/run_payload.hpp"
#include "framework/executor/worker_pool.hpp"
#include "stope/stage_instance.hpp"

namespace stope {

/// One item of a map on its way: its inputs, then what came out.
struct MapItem {
  std::vector<AnyItem> inputs;  ///< one for each port
  Stamp stamp = 0;
  std::uint64_t index = 0;
  std::vector<std::shared_ptr<RunPayload>> outputs;  ///< one for each port; none if nobody reads it
  Outcome outcome;
  std::int64_t work = 0;  ///< ns
};

/// The items of a map that are running or wait to be written, in order: a ring of places.
///
/// The process fills the newest place and submits it; runners on oneTBB workers claim places oldest
/// first, and there are never more runners than workers, nor more than the work that waits is worth
/// waking. A runner keeps claiming while there is work, so that a small item costs an atomic
/// increment rather than a task; after a while it queues up again behind the other tasks of the
/// pool. When the oldest place is done, the process's
/// doorbell rings. Runners may outlive the process, so they share the window and never look at
/// anything else of it once their item is done.
class MapWindow : public std::enable_shared_from_this<MapWindow>, public PoolTask {
 public:
  using Apply = std::function<void(MapItem&)>;  ///< must not throw

  MapWindow(WorkerPool& pool, std::shared_ptr<Doorbell> doorbell, std::size_t places, Apply apply);

  /// Of the process:
  bool empty() const { return oldest_.load() == submitted_.load(); }
  bool full() const { return submitted_.load() - oldest_.load() == places_.size(); }
  std::size_t size() const { return static_cast<std::size_t>(submitted_.load() - oldest_.load()); }
  /// The place to fill next. The window must not be full.
  MapItem& newest() { return places_[submitted_.load() % places_.size()].item; }
  std::vector<MapItem*> all();
  /// Hands the newest place to the workers.
  void submit();
  /// Whether the window holds items and the oldest is done.
  bool oldest_done() const {
    return !empty() && places_[oldest_.load() % places_.size()].done.load();
  }
  MapItem& oldest() { return places_[oldest_.load() % places_.size()].item; }
  /// Frees the oldest place.
  void advance();
  /// Takes back what no worker has begun and waits for what they have.
  void stop();

  void run() noexcept override;

 private:
  struct Place {
    MapItem item;
    std::atomic<bool> done{false};
  };
  /// The next place to run, or none.
  bool claim(std::uint64_t& place);
  /// The same; looks again for a moment if there is none yet.
  bool claim_soon(std::uint64_t& place);
  /// How many runners the places that wait deserve.
  int runners_wanted() const;
  void call_runner();

  WorkerPool& pool_;
  std::shared_ptr<Doorbell> doorbell_;
  Apply apply_;
  std::vector<Place> places_;
  alignas(64) std::atomic<std::uint64_t> submitted_{0};
  alignas(64) std::atomic<std::uint64_t> claimed_{0};
  std::atomic<int> runners_{0};
  std::atomic<std::int64_t> usual_work_;  ///< of an item, ns
  alignas(64) std::atomic<std::uint64_t> oldest_{0};
};

}  // namespace stope
