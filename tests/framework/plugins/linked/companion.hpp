#pragma once

namespace companion {

/// The build of the library.
const char* build();

}  // namespace companion
