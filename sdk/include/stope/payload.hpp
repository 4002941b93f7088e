#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "stope/codec.hpp"
#include "stope/layout.hpp"
#include "stope/time.hpp"

namespace stope {

/// What the framework needs to know of a payload type it has never seen: its name, its layout and
/// how to write, read and measure it. The functions live in the plugin that made the payload;
/// plugins are never unloaded.
struct PayloadType {
  std::string_view name;  ///< `vendor/Name@version`
  std::uint64_t layout = 0;
  void (*encode)(const void* value, ByteSink& sink) = nullptr;
  std::shared_ptr<const void> (*decode)(ByteSource& source) = nullptr;
  std::size_t (*size)(const void* value) = nullptr;  ///< bytes, about
};

/// The PayloadType of T.
template <PayloadStruct T>
const PayloadType& payload_type() {
  static const PayloadType type{
      T::kType, layout_hash<T>(),
      [](const void* value, ByteSink& sink) { encode(*static_cast<const T*>(value), sink); },
      [](ByteSource& source) -> std::shared_ptr<const void> {
        auto value = std::make_shared<T>();
        decode(*value, source);
        return value;
      },
      [](const void* value) { return sizeof(T) + encoded_size(*static_cast<const T*>(value)); }};
  return type;
}

/// An immutable value shared between stages, which may not be in memory at the moment. Made by the
/// framework.
class STOPE_API Payload {
 public:
  virtual ~Payload() = default;
  virtual const PayloadType& type() const noexcept = 0;
  /// The value, brought into memory if need be. It stays there while anyone holds what is returned.
  /// Never waits for memory. Throws Error if the value cannot be loaded. Any thread may call it.
  virtual std::shared_ptr<const void> pin() = 0;
};

/// What travels through a channel: a payload with its time and place in the stream.
struct AnyItem {
  Stamp stamp = 0;          ///< never decreases along a stream
  std::uint64_t index = 0;  ///< strictly increases along a stream
  std::shared_ptr<Payload> payload;
  explicit operator bool() const { return payload != nullptr; }
};

/// Makes a lazy payload's value when it is touched. Must give the same value every time.
using PayloadLoader = std::function<std::shared_ptr<const void>()>;

}  // namespace stope
