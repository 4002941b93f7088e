#include "plugins/planner/route_query.hpp"

#include <algorithm>

namespace stope::planner {

void CostChanges::clear() {
  slots_.clear();
  count_ = 0;
}

void CostChanges::put(std::uint32_t arc, WayCost cost) {
  if (2 * (count_ + 1) > slots_.size()) {
    std::vector<Slot> old(std::max<std::size_t>(16, 2 * slots_.size()));
    old.swap(slots_);
    count_ = 0;
    for (const Slot& kept : old)
      if (kept.arc != kNoArc) put(kept.arc, kept.cost);
  }
  std::size_t i = slot(arc);
  while (slots_[i].arc != kNoArc && slots_[i].arc != arc) i = (i + 1) & (slots_.size() - 1);
  if (slots_[i].arc == kNoArc) {
    ++count_;
    slots_[i] = {arc, cost};
  } else {
    // Told twice, the dearer counts.
    slots_[i].cost = std::max(slots_[i].cost, cost);
  }
}

}  // namespace stope::planner
