#pragma once

#include <string>
#include <vector>

#include "framework/pipeline/located_node.hpp"

namespace stope {

/// One thing that is changed in a pipeline, wherever that was written.
struct Override {
  /// `vars.name`, `stage.use`, `stage.in`, `stage.parameter` or `stage.family/name.parameter`
  std::string key;
  Place place;  ///< of the key, for errors about it
  LocatedNode value;
};

/// Applies overrides to a pipeline's tree, in their order. Reports keys that are malformed and what
/// names nothing.
void apply_overrides(LocatedNode& root, const std::vector<Override>& overrides,
                     Diagnostics& diagnostics);

/// Reads what `--set` says to a pipeline's tree: `vars.name=value`, `stage.use=family/name`,
/// `stage.in=stage.port`, `stage.parameter=value`, `stage.family/name.parameter=value`. Values are
/// YAML. Places are `--set:1`, `--set:2`, …; paths are relative to the working directory. Reports
/// what cannot be read.
std::vector<Override> read_overrides(const std::vector<std::string>& texts,
                                     Diagnostics& diagnostics);

}  // namespace stope
