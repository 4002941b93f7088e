#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace stope::map_source {

/// A folder for a test's own files, removed with it.
class MapFolder {
 public:
  MapFolder();
  ~MapFolder();
  MapFolder(const MapFolder&) = delete;
  MapFolder& operator=(const MapFolder&) = delete;

  std::filesystem::path write(const std::string& name, const std::string& bytes) const;
  /// A sound map yaml for `image`, with `more` lines after it.
  std::filesystem::path write_yaml(const std::string& image, const std::string& more = "") const;
  /// A PNG as libpng writes it. `samples` in the machine's order, 16-bit as two bytes, high first.
  std::filesystem::path write_png(const std::string& name, int width, int height, int depth,
                                  int colour_type, const std::vector<std::uint8_t>& samples,
                                  bool interlaced = false) const;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace stope::map_source
