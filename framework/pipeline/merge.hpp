#pragma once

#include "framework/pipeline/located_node.hpp"

namespace stope {

/// Adds to `below` the vars, stages and outputs of another included file. Reports names that both
/// define, unless `above`, the file that includes them, decides by defining it itself.
void merge_included(LocatedNode& below, const LocatedNode& other, const LocatedNode& above,
                    Diagnostics& diagnostics);

/// Lays the including file `above` over what it includes.
void overlay(LocatedNode& below, const LocatedNode& above);

}  // namespace stope
