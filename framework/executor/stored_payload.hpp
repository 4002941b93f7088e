#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>

#include "framework/executor/run_payload.hpp"
#include "framework/executor/spill_files.hpp"

namespace stope {

class MemoryBudget;
class Shelf;

/// A payload that need not be in memory all the time. It comes back from its loader, if it has one,
/// or from the file it was spilled to; both give the same value every time.
class StoredPayload final : public RunPayload, public std::enable_shared_from_this<StoredPayload> {
 public:
  /// Of a value in memory.
  StoredPayload(const PayloadType& type, std::shared_ptr<const void> value, std::size_t bytes,
                std::shared_ptr<MemoryBudget> budget, Shelf& shelf);
  /// Of a value to be made when it is touched.
  StoredPayload(const PayloadType& type, PayloadLoader load, std::size_t bytes,
                std::shared_ptr<MemoryBudget> budget, Shelf& shelf);
  ~StoredPayload() override;

  const PayloadType& type() const noexcept override { return type_; }
  std::shared_ptr<const void> pin() override;
  /// As it was last seen in memory.
  std::size_t bytes() const override { return bytes_.load(std::memory_order_relaxed); }
  bool lazy() const override { return static_cast<bool>(load_); }
  void set_place(std::uint64_t place) override;
  std::uint64_t place() const { return *place_; }

  /// Takes the value out of memory, writing it to `files` first if it could not come back
  /// otherwise. Gives the bytes freed; 0 if the value is in use. Throws Error if it cannot be
  /// written; the value stays then.
  std::size_t evict(SpillFiles& files);

 private:
  enum State : int { kAbsent, kLoading, kResident, kSpilling };
  std::shared_ptr<const void> load();
  /// Writes the value, which is being evicted, and lets go of it unless it was touched meanwhile.
  bool spill(SpillFiles& files, const std::shared_ptr<const void>& value);

  const PayloadType& type_;
  const std::shared_ptr<MemoryBudget> budget_;
  Shelf& shelf_;
  const PayloadLoader load_;
  std::mutex mutex_;
  std::atomic<int> state_;
  std::shared_ptr<const void> value_;
  std::atomic<std::size_t> bytes_;
  std::optional<SpillPlace> spilled_;
  std::optional<std::uint64_t> place_;
};

}  // namespace stope
