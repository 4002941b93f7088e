#pragma once

#include <nlohmann/json.hpp>

#include "framework/pipeline/plan.hpp"

namespace stope {

/// A value of a parameter as JSON: null, true, 3, "text", [1, 2]. Infinite numbers, which JSON does
/// not have, are the texts "inf" and "-inf".
nlohmann::json value_json(const ParameterValue& value);

/// A plan in canonical form: everything resolved, parameters in SI units with defaults filled in,
/// stages in topological order. Equal plans give equal text.
nlohmann::json plan_json(const Plan& plan);

}  // namespace stope
