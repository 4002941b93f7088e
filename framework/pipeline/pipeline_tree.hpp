#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "framework/pipeline/located_node.hpp"
#include "framework/pipeline/source_text.hpp"

namespace stope {

/// A pipeline file with everything it includes, merged into one map with the keys `name`, `vars`,
/// `stages` and `outputs`, each there only if written.
struct PipelineTree {
  LocatedNode root;
  std::vector<std::filesystem::path> files;  ///< the pipeline first, then what it includes
};

/// Reads a pipeline and the files it includes. The including file wins: its variables and outputs
/// replace those included, its stages are laid over the included ones key by key and parameter by
/// parameter, and one written as `null` is removed. Two included files may not define the same
/// thing unless the including file does. Gives nothing if the pipeline itself cannot be read.
std::optional<PipelineTree> load_pipeline(const SourceText& source, Diagnostics& diagnostics);

}  // namespace stope
