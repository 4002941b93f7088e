#include "framework/executor/payload_store.hpp"

#include <mutex>
#include <utility>

namespace stope {

namespace {

class Simple final : public Payload {
 public:
  Simple(const PayloadType& type, std::shared_ptr<const void> value, PayloadLoader load)
      : type_(type), value_(std::move(value)), load_(std::move(load)) {}
  const PayloadType& type() const noexcept override { return type_; }
  std::shared_ptr<const void> pin() override {
    const std::lock_guard lock(mutex_);
    if (!value_) value_ = load_();
    return value_;
  }

 private:
  const PayloadType& type_;
  std::mutex mutex_;
  std::shared_ptr<const void> value_;
  PayloadLoader load_;
};

}  // namespace

std::shared_ptr<Payload> PayloadStore::keep(const PayloadType& type,
                                            std::shared_ptr<const void> value) {
  return std::make_shared<Simple>(type, std::move(value), nullptr);
}

std::shared_ptr<Payload> PayloadStore::keep_lazy(const PayloadType& type, PayloadLoader load,
                                                 std::size_t) {
  return std::make_shared<Simple>(type, nullptr, std::move(load));
}

}  // namespace stope
