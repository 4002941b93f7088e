#pragma once

#include "framework/cache/cached_run.hpp"
#include "framework/cli/arguments.hpp"

namespace stope {

/// How a command's run uses a store, by its arguments and the environment. `STOPE_CACHE=off` stands
/// for none. Throws WrongArgument if the store's place holds something that is none.
CacheUse cache_use(const Arguments& arguments);

}  // namespace stope
