#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "stope/stage_instance.hpp"

namespace stope {

/// A stage that some plugin offers.
struct StageRecord {
  StageInfo info;
  std::filesystem::path file;  ///< the plugin's library
  std::string plugin_id;
  std::string plugin_version;
  std::string build_id;  ///< of the library, hexadecimal; of one without, a digest of its bytes
  std::string libraries = {};  ///< names the builds of all libraries that it is linked with
};

/// Which stages there are, and how to make one. The pipeline checker and the executor see plugins
/// through it alone.
class Catalogue {
 public:
  virtual ~Catalogue() = default;
  /// All stages, ordered by id.
  virtual const std::vector<StageRecord>& stages() const = 0;
  /// The stage of this id, or null.
  virtual const StageRecord* find(std::string_view id) const = 0;
  /// Loads the stage's library if need be and makes the stage. Throws Error with a sentence that
  /// names the file.
  virtual std::unique_ptr<StageInstance> create(std::string_view id) const = 0;
};

}  // namespace stope
