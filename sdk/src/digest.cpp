#include "stope/digest.hpp"

#include <xxhash.h>

#include <cstdio>
#include <new>

namespace stope {

std::string Digest::text() const {
  char buffer[33];
  std::snprintf(buffer, sizeof(buffer), "%016llx%016llx", static_cast<unsigned long long>(high),
                static_cast<unsigned long long>(low));
  return buffer;
}

struct Digester::State {
  struct Free {
    void operator()(XXH3_state_t* state) const { XXH3_freeState(state); }
  };
  std::unique_ptr<XXH3_state_t, Free> hash{XXH3_createState()};
};

Digester::Digester() : state_(std::make_unique<State>()) {
  if (!state_->hash) throw std::bad_alloc();
  XXH3_128bits_reset(state_->hash.get());
}

Digester::~Digester() = default;

void Digester::write(const void* data, std::size_t size) {
  if (size > 0) XXH3_128bits_update(state_->hash.get(), data, size);
}

Digest Digester::digest() const {
  const XXH128_hash_t hash = XXH3_128bits_digest(state_->hash.get());
  return {hash.high64, hash.low64};
}

}  // namespace stope
