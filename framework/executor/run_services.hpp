#pragma once

#include <cstddef>
#include <cstdint>

#include "framework/executor/payload_store.hpp"
#include "framework/executor/run_log.hpp"
#include "framework/executor/run_state.hpp"
#include "framework/executor/scratch_folder.hpp"
#include "framework/executor/trace.hpp"
#include "framework/executor/wait_graph.hpp"
#include "framework/executor/worker_pool.hpp"

namespace stope {

/// What all processes of a run share.
struct RunServices {
  RunState& state;
  WaitGraph& waits;
  WorkerPool& pool;
  PayloadStore& store;
  RunLog& log;
  ScratchFolder& scratch;
  std::uint64_t seed;
  Trace::Clock::time_point begin;
  std::size_t span_limit;  ///< of each process
};

}  // namespace stope
