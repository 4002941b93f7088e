#include "framework/plugins/layout_check.hpp"

#include <fmt/format.h>

#include "framework/plugins/plugin_file.hpp"
#include "framework/plugins/sdk_payloads.hpp"

namespace stope {

namespace {

constexpr std::string_view kSdkVendor = "stope/";

void check_port(const StageInfo& stage, const PortInfo& port,
                const std::map<std::string, std::uint64_t>& layouts) {
  if (!port.type.starts_with(kSdkVendor)) return;
  const auto known = layouts.find(port.type);
  if (known == layouts.end()) {
    throw PluginRefused(PluginStatus::kOtherLayout,
                        fmt::format("Its stage '{}' exchanges {}, which this Stope does not have: "
                                    "rebuild it against the SDK of this Stope, or use the Stope it "
                                    "was built for.",
                                    stage.id, port.type));
  }
  if (known->second != port.layout) {
    throw PluginRefused(PluginStatus::kOtherLayout,
                        fmt::format("Its stage '{}' lays {} out otherwise than this Stope: rebuild "
                                    "it against the SDK of this Stope.",
                                    stage.id, port.type));
  }
}

}  // namespace

std::map<std::string, std::uint64_t> sdk_layouts() {
  std::map<std::string, std::uint64_t> layouts;
  for (const PayloadType* type : sdk_payloads()) layouts.emplace(type->name, type->layout);
  return layouts;
}

void check_layouts(const Manifest& manifest, const std::map<std::string, std::uint64_t>& layouts) {
  for (const StageInfo& stage : manifest.stages) {
    for (const PortInfo& port : stage.inputs) check_port(stage, port, layouts);
    for (const PortInfo& port : stage.outputs) check_port(stage, port, layouts);
  }
}

}  // namespace stope
