#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>

namespace stope::map_source {

/// How the samples of a picture's row lie in memory.
struct RasterLayout {
  std::int32_t width = 0, height = 0;  ///< pixels
  int channels = 1;                    ///< 1 grey, 2 grey and alpha, 3 RGB, 4 RGB and alpha
  int sample_bytes = 1;                ///< 1, or 2 in the machine's byte order
  unsigned max_value = 255;            ///< of a sample: what counts as white
  bool alpha() const { return channels == 2 || channels == 4; }
  std::size_t row_bytes() const {
    return static_cast<std::size_t>(width) * static_cast<std::size_t>(channels * sample_bytes);
  }
};

/// Reads a picture row by row, the top row first, so that a map of a whole mine never stands in
/// memory twice. Throws Error where the file is cut off or damaged.
class RasterReader {
 public:
  virtual ~RasterReader() = default;
  virtual const RasterLayout& layout() const = 0;
  /// Fills layout().row_bytes() bytes with the next row.
  virtual void read_row(std::uint8_t* row) = 0;
};

/// Opens a PNG, PGM or PPM (P2, P3, P5, P6) picture; its first bytes tell which, not its name.
/// Throws Error.
std::unique_ptr<RasterReader> open_raster(const std::filesystem::path& file);

std::unique_ptr<RasterReader> open_png(const std::filesystem::path& file);
std::unique_ptr<RasterReader> open_pnm(const std::filesystem::path& file);

}  // namespace stope::map_source
