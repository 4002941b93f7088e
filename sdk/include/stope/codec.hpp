#pragma once

#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "stope/error.hpp"
#include "stope/fields.hpp"
#include "stope/label_cells.hpp"
#include "stope/visibility.hpp"

/// The binary form of payloads: little-endian, lengths as 64-bit integers, fields in their declared
/// order. It is what digests are taken of and what the framework spills to disk.
namespace stope {

/// Where encoded bytes go: a digest, a file, a buffer, a counter.
class STOPE_API ByteSink {
 public:
  virtual ~ByteSink() = default;
  virtual void write(const void* data, std::size_t size) = 0;
};

/// Where encoded bytes come from.
class STOPE_API ByteSource {
 public:
  virtual ~ByteSource() = default;
  /// Reads exactly `size` bytes. Throws Error if there are fewer.
  virtual void read(void* data, std::size_t size) = 0;
  /// Bytes left: a stored length beyond it is corrupt.
  virtual std::size_t remaining() const = 0;
};

/// Counts what is written. See encoded_size(), which need not write anything.
class STOPE_API ByteCounter final : public ByteSink {
 public:
  void write(const void*, std::size_t size) override { count_ += size; }
  std::size_t count() const { return count_; }

 private:
  std::size_t count_ = 0;
};

/// Collects what is written.
class STOPE_API ByteBuffer final : public ByteSink {
 public:
  void write(const void* data, std::size_t size) override {
    if (size == 0) return;
    // Not insert(), of which g++ 12 warns falsely.
    const std::size_t end = bytes_.size();
    bytes_.resize(end + size);
    std::memcpy(bytes_.data() + end, data, size);
  }
  const std::vector<std::byte>& bytes() const { return bytes_; }

 private:
  std::vector<std::byte> bytes_;
};

/// Reads from memory it does not own.
class STOPE_API ByteReader final : public ByteSource {
 public:
  explicit ByteReader(std::span<const std::byte> bytes) : bytes_(bytes) {}
  void read(void* data, std::size_t size) override {
    if (size > bytes_.size()) throw Error("the encoded payload ends too early");
    if (size == 0) return;  // an empty vector's data may be null
    std::memcpy(data, bytes_.data(), size);
    bytes_ = bytes_.subspan(size);
  }
  std::size_t remaining() const override { return bytes_.size(); }

 private:
  std::span<const std::byte> bytes_;
};

/// Writes `value` to `sink`.
template <class T>
void encode(const T& value, ByteSink& sink) {
  if constexpr (std::is_same_v<T, bool>) {
    const std::uint8_t byte = value ? 1 : 0;
    sink.write(&byte, 1);
  } else if constexpr (traits::Number<T> || traits::IsFixedEigen<T>::value) {
    sink.write(&value, sizeof(T));
  } else if constexpr (std::is_same_v<T, std::string>) {
    encode<std::uint64_t>(value.size(), sink);
    sink.write(value.data(), value.size());
  } else if constexpr (traits::IsVector<T>::value) {
    using Element = typename T::value_type;
    static_assert(!std::is_same_v<Element, bool>, "use std::vector<std::uint8_t>");
    encode<std::uint64_t>(value.size(), sink);
    if (is_flat<Element>()) {
      sink.write(value.data(), value.size() * sizeof(Element));
    } else {
      for (const Element& element : value) encode(element, sink);
    }
  } else if constexpr (traits::IsArray<T>::value) {
    for (const auto& element : value) encode(element, sink);
  } else if constexpr (traits::IsOptional<T>::value) {
    encode(value.has_value(), sink);
    if (value) encode(*value, sink);
  } else if constexpr (std::is_same_v<T, LabelCells>) {  // as a vector
    encode<std::uint64_t>(value.size(), sink);
    value.for_each_piece([&sink](std::span<const std::int32_t> labels) {
      sink.write(labels.data(), labels.size_bytes());
    });
  } else {
    static_assert(HasFields<T>, "a field must be a kind that stope/fields.hpp lists");
    T::fields(value, [&sink](const char*, const auto& member) { encode(member, sink); });
  }
}

/// Reads a `value` that encode() wrote. Throws Error if the bytes end early or a length cannot be
/// right.
template <class T>
void decode(T& value, ByteSource& source) {
  if constexpr (std::is_same_v<T, bool>) {
    std::uint8_t byte = 0;
    source.read(&byte, 1);
    value = byte != 0;
  } else if constexpr (traits::Number<T> || traits::IsFixedEigen<T>::value) {
    source.read(static_cast<void*>(&value), sizeof(T));
  } else if constexpr (std::is_same_v<T, std::string> || traits::IsVector<T>::value) {
    std::uint64_t size = 0;
    decode(size, source);
    using Element = typename T::value_type;
    const std::size_t least = is_flat<Element>() ? sizeof(Element) : 1;
    if (size > source.remaining() / least)
      throw Error("the encoded payload holds a length beyond its end");
    value.resize(size);
    if (is_flat<Element>()) {
      source.read(static_cast<void*>(value.data()), size * sizeof(Element));
    } else if constexpr (!std::is_same_v<T, std::string>) {
      for (Element& element : value) decode(element, source);
    }
  } else if constexpr (traits::IsArray<T>::value) {
    for (auto& element : value) decode(element, source);
  } else if constexpr (traits::IsOptional<T>::value) {
    bool present = false;
    decode(present, source);
    if (present) {
      decode(value.emplace(), source);
    } else {
      value.reset();
    }
  } else if constexpr (std::is_same_v<T, LabelCells>) {
    std::vector<std::int32_t> labels;
    decode(labels, source);
    value = std::move(labels);
  } else {
    static_assert(HasFields<T>, "a field must be a kind that stope/fields.hpp lists");
    T::fields(value, [&source](const char*, auto& member) { decode(member, source); });
  }
}

/// Bytes that encode() would write: near what the value holds in memory. Cheap, because flat
/// vectors count in one step and shared labels need not be looked up.
template <class T>
std::size_t encoded_size(const T& value) {
  if constexpr (traits::Number<T> || std::is_same_v<T, bool> || traits::IsFixedEigen<T>::value) {
    return sizeof(T);
  } else if constexpr (std::is_same_v<T, std::string>) {
    return sizeof(std::uint64_t) + value.size();
  } else if constexpr (std::is_same_v<T, LabelCells>) {
    return sizeof(std::uint64_t) + value.size() * sizeof(std::int32_t);
  } else if constexpr (traits::IsVector<T>::value || traits::IsArray<T>::value) {
    using Element = typename T::value_type;
    std::size_t size = traits::IsVector<T>::value ? sizeof(std::uint64_t) : 0;
    if (is_flat<Element>()) return size + value.size() * sizeof(Element);
    for (const Element& element : value) size += encoded_size(element);
    return size;
  } else if constexpr (traits::IsOptional<T>::value) {
    return 1 + (value ? encoded_size(*value) : 0);
  } else {
    static_assert(HasFields<T>, "a field must be a kind that stope/fields.hpp lists");
    std::size_t size = 0;
    T::fields(value, [&size](const char*, const auto& member) { size += encoded_size(member); });
    return size;
  }
}

}  // namespace stope
