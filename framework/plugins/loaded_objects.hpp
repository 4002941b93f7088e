#pragma once

#include <string>
#include <vector>

namespace stope {

/// A program or library in this process.
struct LoadedObject {
  std::string file;  ///< as the dynamic linker found it
  std::string name;  ///< by which others ask for it; if it has none of its own, the file's
  std::vector<std::string> needed;  ///< names of those it asks for
  std::string build_id;             ///< hexadecimal, or empty
};

/// All that have a file of their own, but the program itself.
std::vector<LoadedObject> loaded_objects();

}  // namespace stope
