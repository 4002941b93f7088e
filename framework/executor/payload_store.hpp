#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <string>

#include "framework/executor/memory_budget.hpp"
#include "framework/executor/run_payload.hpp"

namespace stope {

/// Makes the payloads of a run and keeps them within its memory.
class PayloadStore {
 public:
  /// See MemoryBudget.
  PayloadStore(std::size_t limit, ScratchFolder& scratch,
               std::function<void(const std::string&)> disk_failed)
      : budget_(std::make_shared<MemoryBudget>(limit, scratch, std::move(disk_failed))) {}

  /// One for each output. Before the run begins.
  Shelf& add_shelf() { return budget_->add_shelf(); }
  /// A payload of a value that exists. From any thread.
  std::shared_ptr<RunPayload> keep(const PayloadType& type, std::shared_ptr<const void> value,
                                   Shelf& shelf);
  /// A payload whose value `load` makes when it is touched; `bytes` is its size, about.
  std::shared_ptr<RunPayload> keep_lazy(const PayloadType& type, PayloadLoader load,
                                        std::size_t bytes, Shelf& shelf);

  /// How many bytes a map may have made and not written yet: they cannot be evicted.
  std::size_t bytes_of_a_window() const { return budget_->limit() / 32; }

  void look() { budget_->look(); }
  void close() { budget_->close(); }
  void record(RunRecord& record) const { budget_->record(record); }

 private:
  std::shared_ptr<MemoryBudget> budget_;  ///< payloads share it and may outlive the run
};

}  // namespace stope
