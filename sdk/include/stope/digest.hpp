#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "stope/codec.hpp"

namespace stope {

/// A 128-bit XXH3 hash. Equal digests mean equal bytes for every practical purpose; it is no
/// defence against forgery.
struct STOPE_API Digest {
  std::uint64_t high = 0, low = 0;
  bool operator==(const Digest&) const = default;
  auto operator<=>(const Digest&) const = default;
  /// 32 hexadecimal digits.
  std::string text() const;
};

/// Digests what is written to it, piece by piece.
class STOPE_API Digester final : public ByteSink {
 public:
  Digester();
  ~Digester() override;
  Digester(const Digester&) = delete;
  Digester& operator=(const Digester&) = delete;
  void write(const void* data, std::size_t size) override;
  Digest digest() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// The digest of a value's encoded form.
template <class T>
Digest digest_of(const T& value) {
  Digester digester;
  encode(value, digester);
  return digester.digest();
}

}  // namespace stope
