#pragma once

#include <nlohmann/json.hpp>

#include "framework/plugins/catalogue.hpp"

namespace stope {

/// The JSON Schema (draft 7) of pipeline files that use these stages, for editors: completes and
/// explains stages, inputs and parameters while someone writes. It accepts what `stope check`
/// accepts and more, because wires, units' dimensions and variables are beyond a schema.
nlohmann::json pipeline_schema(const Catalogue& catalogue);

}  // namespace stope
