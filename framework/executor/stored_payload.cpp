#include "framework/executor/stored_payload.hpp"

#include <utility>

#include "framework/executor/memory_budget.hpp"
#include "framework/executor/shelf.hpp"
#include "framework/executor/trace.hpp"
#include "framework/executor/worker_pool.hpp"

namespace stope {

StoredPayload::StoredPayload(const PayloadType& type, std::shared_ptr<const void> value,
                             std::size_t bytes, std::shared_ptr<MemoryBudget> budget, Shelf& shelf)
    : type_(type),
      budget_(std::move(budget)),
      shelf_(shelf),
      state_(kResident),
      value_(std::move(value)),
      bytes_(bytes) {}

StoredPayload::StoredPayload(const PayloadType& type, PayloadLoader load, std::size_t bytes,
                             std::shared_ptr<MemoryBudget> budget, Shelf& shelf)
    : type_(type),
      budget_(std::move(budget)),
      shelf_(shelf),
      load_(std::move(load)),
      state_(kAbsent),
      bytes_(bytes) {}

StoredPayload::~StoredPayload() {
  if (place_) shelf_.erase(*place_);
  if (value_) budget_->freed(bytes_);
}

void StoredPayload::set_place(std::uint64_t place) {
  const std::lock_guard lock(mutex_);
  place_ = place;
  if (value_) shelf_.insert(place, *this);
}

std::shared_ptr<const void> StoredPayload::pin() {
  for (;;) {
    {
      const std::lock_guard lock(mutex_);
      if (value_) return value_;
      if (state_ == kAbsent) {
        state_ = kLoading;
        break;
      }
    }
    state_.wait(kLoading);
  }
  // No lock is held from here on, and no memory is waited for: others are evicted, or not.
  std::shared_ptr<const void> value;
  try {
    budget_->make_room(bytes_);
    value = load();
  } catch (...) {
    state_ = kAbsent;
    state_.notify_all();
    throw;
  }
  {
    const std::lock_guard lock(mutex_);
    value_ = value;
    bytes_ = type_.size(value.get());
    state_ = kResident;
    if (place_) shelf_.insert(*place_, *this);
  }
  state_.notify_all();
  return value;
}

std::shared_ptr<const void> StoredPayload::load() {
  const IoSpan span;
  std::shared_ptr<const void> value;
  if (!load_) {
    value = read_back(type_, *spilled_);
  } else {
    // Other payloads may be touched by tasks that this thread would take while it waits.
    WorkerPool::run_isolated([&] { value = load_(); });
    if (!value) throw Error("the loader of a lazy item gave no value");
  }
  budget_->loaded();
  return value;
}

std::size_t StoredPayload::evict(SpillFiles& files) {
  std::shared_ptr<const void> value;
  std::size_t bytes = 0;
  bool must_spill = false;
  {
    const std::lock_guard lock(mutex_);
    // One owner is this payload: nobody else uses the value, and nobody can begin to without the
    // lock.
    if (state_ != kResident || value_.use_count() > 1) return 0;
    bytes = bytes_;
    value = value_;
    must_spill = !load_ && !spilled_;
    if (!must_spill) value_.reset();
    state_ = must_spill ? kSpilling : kAbsent;
  }
  if (must_spill && !spill(files, value)) return 0;
  value.reset();
  budget_->freed(bytes);
  budget_->evicted();
  return bytes;
}

bool StoredPayload::spill(SpillFiles& files, const std::shared_ptr<const void>& value) {
  std::optional<SpillPlace> place;
  try {
    place = files.write(type_, value.get());
  } catch (...) {
    state_ = kResident;
    throw;
  }
  budget_->spilled(place->size);
  const std::lock_guard lock(mutex_);
  spilled_ = std::move(place);
  const bool touched_meanwhile = value.use_count() > 2;
  if (!touched_meanwhile) value_.reset();
  state_ = touched_meanwhile ? kResident : kAbsent;
  return !touched_meanwhile;
}

}  // namespace stope
