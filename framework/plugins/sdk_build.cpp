#include "framework/plugins/sdk_build.hpp"

#include "framework/plugins/loaded_objects.hpp"
#include "framework/plugins/open_file.hpp"
#include "framework/plugins/plugin_file.hpp"

namespace stope {

bool is_sdk(const LoadedObject& object) { return object.name.starts_with("libstope.so"); }

std::string sdk_build_id() {
  for (const LoadedObject& object : loaded_objects()) {
    if (!is_sdk(object)) continue;
    if (!object.build_id.empty()) return object.build_id;
    try {
      return OpenFile(object.file).digest();
    } catch (const PluginRefused&) {
      return {};  // removed since it was loaded
    }
  }
  return {};
}

}  // namespace stope
