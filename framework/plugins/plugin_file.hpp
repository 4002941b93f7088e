#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "stope/error.hpp"

namespace stope {

/// What became of a plugin file.
enum class PluginStatus : int {
  kUsable,
  kNotALibrary,
  kTruncated,
  kOtherMachine,  ///< built for another processor, or needs features this one lacks
  kNoNote,        ///< a library, but not a plugin
  kOtherEpoch,
  kBuiltOtherwise,  ///< compiler, standard library, alignment, sanitizers or fast-math differ
  kFailed,          ///< could not be opened or described
  kCrashed,
  kHung,
  kExited,
  kFloatingPoint,   ///< changes the floating-point modes of whoever loads it
  kInvalid,         ///< describes a stage that cannot be
  kOtherLayout,     ///< a payload of the SDK has another layout
  kDuplicateStage,  ///< another file offers the same stage
};

/// A short name for programs, such as `other-epoch`.
std::string_view status_name(PluginStatus status);

/// One file found in a plugin folder.
struct PluginFile {
  std::filesystem::path path;
  PluginStatus status = PluginStatus::kUsable;
  std::string sentence;  ///< what is wrong with it and what to do; empty if nothing is
  std::string plugin_id, plugin_version, build_id;  ///< as far as they could be read
  std::vector<std::string> stages;                  ///< ids of the usable ones, ordered
  bool cached = false;  ///< what it declares is known from an earlier probe
  bool usable() const { return status == PluginStatus::kUsable; }
};

/// Thrown where a file turns out unusable. The text is the sentence, without the file's name.
class PluginRefused : public Error {
 public:
  PluginRefused(PluginStatus status, const std::string& sentence)
      : Error(sentence), status_(status) {}
  PluginStatus status() const { return status_; }

 private:
  PluginStatus status_;
};

}  // namespace stope
