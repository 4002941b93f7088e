#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace stope {

/// What a process does with its time.
enum class Activity : std::uint8_t { kRun, kWaitIn, kWaitOut, kIo };

/// A stretch of one activity of a process, in nanoseconds since the run began. Where a process has
/// too many to keep, the spans are aggregated: `count` > 1 and `busy` < end - begin.
struct Span {
  Activity activity = Activity::kRun;
  std::int64_t begin = 0, end = 0;
  std::int64_t busy = 0;  ///< nanoseconds of this activity in it
  std::uint64_t count = 1;
};

/// How one process (a stage or a sink) spent the run.
struct ProcessRecord {
  std::string name;
  std::int64_t begin = 0, end = 0;                          ///< its life, ns since the run began
  std::int64_t run = 0, wait_in = 0, wait_out = 0, io = 0;  ///< sums, ns
  std::int64_t work = 0;                                    ///< of a map: summed over its items, ns
  std::uint64_t items_read = 0, items_written = 0;
  std::vector<Span> spans;
};

/// How one channel was used.
struct ChannelRecord {
  std::string from, to;  ///< `stage.port`
  std::uint64_t items = 0;
  std::size_t capacity = 0;   ///< at the end
  std::uint32_t growths = 0;  ///< times it doubled to resolve an artificial deadlock
};

/// What went wrong in a stage or a sink.
struct StageFailure {
  std::string stage;     ///< empty: of the run itself
  std::string sentence;  ///< names stage, item, time and what went wrong
};

/// How a run went.
struct RunRecord {
  enum class End : std::uint8_t { kDone, kFailed, kCancelled } end = End::kDone;
  std::string sentence;  ///< of the first failure: stage, item, time and what went wrong
  std::string failed_stage;
  std::vector<StageFailure> failures;  ///< one, or all of a run that goes on after a failure
  bool stopped = false;   ///< whether it ended before all was done that did not depend on a failure
  std::int64_t wall = 0;  ///< ns
  std::vector<ProcessRecord> processes;
  std::vector<ChannelRecord> channels;
  std::uint64_t payloads_loaded = 0, payloads_spilled = 0, payloads_evicted = 0;
  std::uint64_t bytes_spilled = 0;
  std::size_t peak_resident = 0;  ///< bytes, VmHWM of the process
};

}  // namespace stope
