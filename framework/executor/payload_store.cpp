#include "framework/executor/payload_store.hpp"

#include <utility>

#include "framework/executor/stored_payload.hpp"

namespace stope {

namespace {

constexpr std::size_t kSmall = 1024;  ///< not worth the trouble of a place on disk

}  // namespace

std::shared_ptr<RunPayload> PayloadStore::keep(const PayloadType& type,
                                               std::shared_ptr<const void> value, Shelf& shelf) {
  const std::size_t bytes = type.size(value.get());
  budget_->make_room(bytes);
  if (bytes < kSmall) return std::make_shared<SmallPayload>(type, std::move(value), bytes);
  return std::make_shared<StoredPayload>(type, std::move(value), bytes, budget_, shelf);
}

std::shared_ptr<RunPayload> PayloadStore::keep_lazy(const PayloadType& type, PayloadLoader load,
                                                    std::size_t bytes, Shelf& shelf) {
  return std::make_shared<StoredPayload>(type, std::move(load), bytes, budget_, shelf);
}

}  // namespace stope
