#include "framework/cli/cache_use.hpp"

#include <cstdlib>
#include <string>

#include "framework/cache/store_folder.hpp"
#include "framework/cli/wrong_argument.hpp"

namespace stope {

namespace {

bool store_is_off() {
  const char* named = std::getenv("STOPE_CACHE");
  return named && std::string(named) == "off";
}

}  // namespace

CacheUse cache_use(const Arguments& arguments) {
  CacheUse use;
  if (arguments.cache_limit > 0) use.limit = arguments.cache_limit;
  if (arguments.no_cache) return use;
  if (arguments.cache.empty() && store_is_off()) return use;
  use.store = arguments.cache.empty() ? default_store() : arguments.cache;
  if (!use.store.empty()) use.store = std::filesystem::absolute(use.store);
  if (const std::string why = use.store.empty() ? "" : why_no_store(use.store); !why.empty())
    throw WrongArgument(why);
  const std::string keep =
      arguments.keep.empty() ? (arguments.resume ? "all" : "values") : arguments.keep;
  use.keep = keep == "none" ? Keep::kNothing : keep == "all" ? Keep::kAll : Keep::kValues;
  return use;
}

}  // namespace stope
