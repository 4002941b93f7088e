#include "framework/plugins/plugin_file.hpp"

namespace stope {

std::string_view status_name(PluginStatus status) {
  switch (status) {
    case PluginStatus::kUsable:
      return "usable";
    case PluginStatus::kNotALibrary:
      return "not-a-library";
    case PluginStatus::kTruncated:
      return "truncated";
    case PluginStatus::kOtherMachine:
      return "other-machine";
    case PluginStatus::kNoNote:
      return "no-note";
    case PluginStatus::kOtherEpoch:
      return "other-epoch";
    case PluginStatus::kBuiltOtherwise:
      return "built-otherwise";
    case PluginStatus::kFailed:
      return "failed";
    case PluginStatus::kCrashed:
      return "crashed";
    case PluginStatus::kHung:
      return "hung";
    case PluginStatus::kExited:
      return "exited";
    case PluginStatus::kFloatingPoint:
      return "floating-point";
    case PluginStatus::kInvalid:
      return "invalid";
    case PluginStatus::kOtherLayout:
      return "other-layout";
    case PluginStatus::kDuplicateStage:
      return "duplicate-stage";
  }
  return "unknown";
}

}  // namespace stope
