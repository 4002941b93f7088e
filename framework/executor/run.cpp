#include "framework/executor/run.hpp"

#include <algorithm>
#include <chrono>

#include "framework/executor/allocator.hpp"
#include "framework/executor/monitor.hpp"
#include "framework/executor/network.hpp"

namespace stope {

namespace {

constexpr std::size_t kSpansOfARun = 100'000;
constexpr int kLooksPerProgress = 10;  ///< of the monitor

std::size_t count_processes(const Plan& plan, const std::vector<Sink>& sinks) {
  return plan.stages.size() + sinks.size();
}

void run_network(Network& network, RunState& state, PayloadStore& store, const RunOptions& options,
                 const std::function<void(const RunProgress&)>& progress) {
  {
    int looks = 0;
    const Monitor monitor([&] {
      if (options.stop && options.stop->load()) state.cancel();
      store.look();
      if (progress && looks++ % kLooksPerProgress == 0) progress(network.progress());
    });
    network.run(state);
  }
  if (progress) progress(network.progress());
}

}  // namespace

RunRecord run_plan(const Plan& plan, const Catalogue& catalogue, const std::vector<Sink>& sinks,
                   const RunOptions& options, RunObserver& observer,
                   const std::function<void(const RunProgress&)>& progress) {
  const Trace::Clock::time_point begin = Trace::Clock::now();
  const std::size_t processes = count_processes(plan, sinks);
  RunRecord record;
  RunState state(options.go_on_after_failure);
  {
    ScratchFolder scratch(options.scratch);
    set_allocator_up();
    PayloadStore store(options.memory, scratch,
                       [&](const std::string& sentence) { state.fail("", sentence); });
    RunLog log(observer);
    WaitGraph waits(processes);
    WorkerPool pool(options.threads);
    const RunServices services{
        state,        waits, pool,
        store,        log,   scratch,
        options.seed, begin, kSpansOfARun / std::max<std::size_t>(processes, 1)};
    try {
      Network network(plan, catalogue, sinks, options.channel_capacity, services);
      run_network(network, state, store, options, progress);
      network.record(record);
    } catch (const Error& error) {
      state.fail("", error.what());
    }
    store.close();
    store.record(record);
  }
  state.record(record);
  record.wall =
      std::chrono::duration_cast<std::chrono::nanoseconds>(Trace::Clock::now() - begin).count();
  return record;
}

}  // namespace stope
