#pragma once

#include <string>
#include <vector>

#include "framework/pipeline/located_node.hpp"

namespace stope {

/// Applies what `--set` says to a pipeline's tree: `vars.name=value`, `stage.use=family/name`,
/// `stage.in=stage.port`, `stage.parameter=value`, `stage.family/name.parameter=value`. Values are
/// YAML. Places are `--set:1`, `--set:2`, …; paths are relative to the working directory. Reports
/// what is malformed and what names nothing.
void apply_overrides(LocatedNode& root, const std::vector<std::string>& overrides,
                     Diagnostics& diagnostics);

}  // namespace stope
