#pragma once

#include <string>
#include <vector>

#include "framework/compare/experiment/experiment.hpp"

namespace stope {

/// What variants are called in sentences, and what they may say besides overrides.
struct VariantKind {
  std::string one;  ///< `arm`
  bool may_set_base = false, may_set_seed = false;
};

/// Reads `arms:` or `recordings:`: variants by name, each a map of overrides or nothing, and under
/// `cross:` axes of choices of which every combination is a variant. An axis is a list of values
/// for the override that it is called by, or a map of named choices. Reports what is wrong.
std::vector<Variant> read_variants(const LocatedNode& node, const VariantKind& kind,
                                   Diagnostics& diagnostics);

/// The overrides in a map; reports if it is none.
std::vector<Override> overrides_in(const LocatedNode& node, Diagnostics& diagnostics);

/// A whole number of 0 or more; reports what is none.
std::optional<std::uint64_t> seed_in(const LocatedNode& node, Diagnostics& diagnostics);

}  // namespace stope
