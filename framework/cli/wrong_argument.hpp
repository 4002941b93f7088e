#pragma once

#include "stope/error.hpp"

namespace stope {

/// What was typed, or set in the environment, cannot be meant; the command ends with
/// kWrongArguments and this sentence.
class WrongArgument : public Error {
 public:
  using Error::Error;
};

}  // namespace stope
