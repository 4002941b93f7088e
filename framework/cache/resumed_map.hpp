#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <vector>

#include "framework/cache/kept_stage.hpp"
#include "framework/cache/object_store.hpp"
#include "stope/stage_instance.hpp"

namespace stope {

/// Items that a map had made when an earlier run was stopped, by output and index.
using MadeItems = std::vector<std::map<std::uint64_t, KeptItem>>;

/// A map that takes from the store what an earlier run had made of its items before it was stopped,
/// without touching their inputs, and computes the others. `store` must live as long.
std::unique_ptr<StageInstance> resume_map(std::unique_ptr<StageInstance> original, MadeItems made,
                                          ObjectStore& store);

}  // namespace stope
