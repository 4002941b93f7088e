#include "tests/framework/plugins/linked/companion.hpp"

namespace companion {

const char* build() { return COMPANION_BUILD; }

}  // namespace companion
