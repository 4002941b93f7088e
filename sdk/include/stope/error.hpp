#pragma once

#include <stdexcept>

#include "stope/visibility.hpp"

namespace stope {

/// What a stage throws when it cannot go on. The text is a sentence for an operator: what is wrong,
/// what was expected, what to do. The framework adds the stage, the item and its time.
class STOPE_API Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Thrown by ports and by Context::stop_if_cancelled() when the run is being stopped. A stage lets
/// it pass.
class STOPE_API Cancelled : public std::exception {
 public:
  const char* what() const noexcept override { return "the run was cancelled"; }
};

}  // namespace stope
