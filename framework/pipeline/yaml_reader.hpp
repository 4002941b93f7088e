#pragma once

#include <optional>

#include "framework/pipeline/located_node.hpp"
#include "framework/pipeline/source_text.hpp"

namespace stope {

/// Reads YAML into a tree whose every node knows its place. Reports what is wrong with the YAML
/// itself: syntax, duplicate keys, quotes that never close, tags, merge keys, several documents,
/// aliases that expand without end. Gives nothing if the text cannot be read to its end or is
/// empty.
std::optional<LocatedNode> read_yaml(const SourceText& source, Diagnostics& diagnostics);

}  // namespace stope
