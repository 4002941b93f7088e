#include "plugins/topology/for_each_band.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <thread>

namespace stope::topology {

void for_each_band(std::int32_t bands, const Checkpoint& checkpoint,
                   const std::function<BandWork()>& make_work) {
  checkpoint();
  const std::thread::id caller = std::this_thread::get_id();
  const auto work_on = [&](const tbb::blocked_range<std::int32_t>& range) {
    const BandWork work = make_work();
    for (std::int32_t band = range.begin(); band < range.end(); ++band) {
      if (std::this_thread::get_id() == caller) checkpoint();
      work(band);
    }
  };
  // Isolated, or the caller might take up another map while it waits for the last bands.
  tbb::this_task_arena::isolate(
      [&] { tbb::parallel_for(tbb::blocked_range<std::int32_t>(0, bands), work_on); });
}

}  // namespace stope::topology
