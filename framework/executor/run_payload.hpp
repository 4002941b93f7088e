#pragma once

#include <cstdint>
#include <memory>
#include <utility>

#include "stope/payload.hpp"

namespace stope {

/// A payload of a run.
class RunPayload : public Payload {
 public:
  /// It has become the item number `place` of its output.
  virtual void set_place(std::uint64_t /*place*/) {}
};

/// A payload too small to be worth moving to disk.
class SmallPayload final : public RunPayload {
 public:
  SmallPayload(const PayloadType& type, std::shared_ptr<const void> value)
      : type_(type), value_(std::move(value)) {}
  const PayloadType& type() const noexcept override { return type_; }
  std::shared_ptr<const void> pin() override { return value_; }

 private:
  const PayloadType& type_;
  std::shared_ptr<const void> value_;
};

}  // namespace stope
