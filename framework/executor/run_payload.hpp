#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>

#include "stope/payload.hpp"

namespace stope {

/// A payload of a run.
class RunPayload : public Payload {
 public:
  /// Bytes it takes when it is in memory, about.
  virtual std::size_t bytes() const = 0;
  /// Whether it is made by a loader of its stage, which holds nothing that is worth keeping.
  virtual bool lazy() const { return false; }
  /// It has become the item number `place` of its output.
  virtual void set_place(std::uint64_t /*place*/) {}
};

/// A payload too small to be worth moving to disk.
class SmallPayload final : public RunPayload {
 public:
  SmallPayload(const PayloadType& type, std::shared_ptr<const void> value, std::size_t bytes)
      : type_(type), value_(std::move(value)), bytes_(bytes) {}
  std::size_t bytes() const override { return bytes_; }
  const PayloadType& type() const noexcept override { return type_; }
  std::shared_ptr<const void> pin() override { return value_; }

 private:
  const PayloadType& type_;
  std::shared_ptr<const void> value_;
  std::size_t bytes_;
};

}  // namespace stope
