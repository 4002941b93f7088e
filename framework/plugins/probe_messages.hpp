#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "framework/plugins/plugin_file.hpp"

namespace stope {

/// What the child of a probe tells its parent.
struct ProbeMessage {
  enum Kind : std::uint32_t {
    kDoing,     ///< text: what it is about to do
    kRefused,   ///< status and text: why the plugin cannot be used
    kManifest,  ///< text: an encoded manifest
    kAllWell,   ///< the last word; without it nothing before counts
  } kind = kDoing;
  PluginStatus status = PluginStatus::kUsable;
  std::string text;
};

/// Writes a message to a pipe. Nothing is thrown: a parent that has gone needs no telling.
void write_message(int descriptor, const ProbeMessage& message) noexcept;

/// Puts messages together again from pieces.
class ProbeMessageReader {
 public:
  void add(std::string_view bytes) { bytes_ += bytes; }
  /// The next whole message, if there is one. Throws Error if the bytes are no message.
  std::optional<ProbeMessage> next();

 private:
  std::string bytes_;
};

}  // namespace stope
