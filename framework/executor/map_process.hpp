#pragma once

#include <atomic>
#include <memory>
#include <vector>

#include "framework/executor/map_window.hpp"
#include "framework/executor/process.hpp"
#include "framework/executor/stage_context.hpp"
#include "framework/pipeline/plan.hpp"

namespace stope {

/// A map as a process: reads its streams in step, lets oneTBB workers apply the map to several
/// items at once, and writes what comes out in order, each as soon as it and all before it are done
/// — also while it waits for input.
class MapProcess final : public Process {
 public:
  MapProcess(const PlannedStage& stage, const RunServices& services,
             std::unique_ptr<StageInstance> instance);

 private:
  Outcome work() override;
  std::int64_t work_elsewhere() const override { return work_; }
  void release() override;

  void open();
  void hold_values();
  /// Reads one item of each stream into the window's newest place. False when all have ended.
  bool read_step();
  void require_equal_stamps(const MapItem& item, std::size_t port) const;
  /// The next item of a stream; none when it has ended. Writes what is done while it waits.
  AnyItem next(InputEnd& input);
  /// Writes all done items at the front of the window. False if there were none.
  bool write_done();
  /// Whether nothing more should be begun before something is written.
  bool full() const;
  void wait_for_oldest();
  void apply(MapItem& item);

  WorkerPool& pool_;
  StageContext context_;
  std::unique_ptr<StageInstance> instance_;
  std::shared_ptr<MapWindow> window_;
  std::vector<std::size_t> streams_;                      ///< ports that carry a stream
  std::vector<std::shared_ptr<const void>> held_values_;  ///< stay in memory while the map runs
  std::vector<std::shared_ptr<RunPayload>> written_;      ///< what is just being written
  std::size_t most_bytes_;
  std::atomic<std::size_t> unwritten_bytes_{0};  ///< of payloads in the window
  std::int64_t work_ = 0;
};

}  // namespace stope
