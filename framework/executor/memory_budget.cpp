#include "framework/executor/memory_budget.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "framework/executor/allocator.hpp"
#include "framework/executor/stored_payload.hpp"
#include "framework/executor/trace.hpp"

namespace stope {

namespace {

constexpr std::size_t kLeastStep = 128U << 10U;

}  // namespace

MemoryBudget::MemoryBudget(std::size_t limit, ScratchFolder& scratch,
                           std::function<void(const std::string&)> disk_failed)
    : limit_(limit != 0 ? limit : ResidentSize::of_machine() / 2),
      upper_(limit_ / 100 * 90),
      lower_(limit_ / 100 * 86),
      step_(std::max(kLeastStep, limit_ / 128)),
      files_(scratch),
      disk_failed_(std::move(disk_failed)) {}

Shelf& MemoryBudget::add_shelf() {
  shelves_.push_back(std::make_unique<Shelf>());
  return *shelves_.back();
}

void MemoryBudget::make_room(std::size_t bytes) {
  if (closed_.load(std::memory_order_relaxed)) return;
  if (fresh_.fetch_add(bytes, std::memory_order_relaxed) + bytes >= step_) measure();
  if (debt_.load(std::memory_order_relaxed) > 0) pay();
}

void MemoryBudget::look() {
  measure();
  if (debt_.load(std::memory_order_relaxed) > 0) pay();
}

void MemoryBudget::freed(std::size_t bytes) {
  if (bytes < kOwnMappingFrom) kept_by_malloc_.fetch_add(bytes, std::memory_order_relaxed);
}

void MemoryBudget::spilled(std::size_t bytes) {
  spilled_.fetch_add(1, std::memory_order_relaxed);
  bytes_spilled_.fetch_add(bytes, std::memory_order_relaxed);
}

void MemoryBudget::measure() {
  const std::unique_lock lock(measuring_, std::try_to_lock);
  if (!lock) return;
  // What is about to come in counts as if it were there.
  const std::size_t fresh = fresh_.exchange(0);
  std::size_t size = resident_.measure() + std::min(fresh, step_);
  if (size <= upper_) return;
  if (kept_by_malloc_.load() > limit_ / 32) {
    kept_by_malloc_.store(0);
    return_free_memory();
    size = resident_.measure() + std::min(fresh, step_);
  }
  round_.fetch_add(1);
  debt_.store(size > upper_ ? static_cast<std::int64_t>(size - lower_) : 0);
}

void MemoryBudget::pay() {
  const IoSpan span;
  try {
    while (debt_.load() > 0 && !closed_.load()) {
      const auto freed = evict_furthest();
      if (!freed) {
        debt_.store(0);
      } else {
        debt_.fetch_sub(static_cast<std::int64_t>(*freed));
      }
    }
  } catch (const Error& error) {
    // Not the fault of the stage whose payload needs the room, and not for it to catch.
    closed_.store(true);
    disk_failed_(fmt::format(
        "payloads beyond the memory budget of {} MiB cannot be moved to disk: {}; make room there, "
        "choose another place, or allow more memory",
        limit_ >> 20U, error.what()));
  }
}

std::optional<std::size_t> MemoryBudget::evict_furthest() {
  const std::uint64_t round = round_.load();
  Shelf* best = nullptr;
  std::uint64_t furthest = 0;
  for (const auto& shelf : shelves_) {
    const auto distance = shelf->furthest(round);
    if (distance && (!best || *distance > furthest)) {
      best = shelf.get();
      furthest = *distance;
    }
  }
  if (!best) return std::nullopt;
  const auto payload = best->take_furthest(round);
  if (!payload) return 0;
  std::size_t freed = 0;
  try {
    freed = payload->evict(files_);
  } catch (...) {
    best->put_back(payload->place(), *payload, round);
    throw;
  }
  if (freed == 0) best->put_back(payload->place(), *payload, round);
  return freed;
}

void MemoryBudget::record(RunRecord& record) const {
  record.payloads_loaded = loaded_.load();
  record.payloads_evicted = evicted_.load();
  record.payloads_spilled = spilled_.load();
  record.bytes_spilled = bytes_spilled_.load();
  record.peak_resident = ResidentSize::peak();
}

}  // namespace stope
