#pragma once

#include <cstddef>
#include <memory>

#include "stope/payload.hpp"

namespace stope {

/// Makes the payloads of a run and keeps them within its memory.
class PayloadStore {
 public:
  /// A payload of a value that exists.
  std::shared_ptr<Payload> keep(const PayloadType& type, std::shared_ptr<const void> value);
  /// A payload whose value `load` makes when it is touched; `bytes` is its size, about.
  std::shared_ptr<Payload> keep_lazy(const PayloadType& type, PayloadLoader load,
                                     std::size_t bytes);
};

}  // namespace stope
