#include "plugins/map_source/raster_reader.hpp"

#include <fmt/format.h>

#include <array>
#include <fstream>
#include <string_view>

#include "stope/error.hpp"

namespace stope::map_source {

std::unique_ptr<RasterReader> open_raster(const std::filesystem::path& file) {
  std::error_code problem;
  if (!std::filesystem::exists(file, problem))
    throw Error(fmt::format("the map's picture {} does not exist", file.string()));
  if (!std::filesystem::is_regular_file(file, problem))
    throw Error(fmt::format("the map's picture {} is not a file", file.string()));
  std::ifstream stream(file, std::ios::binary);
  std::array<char, 4> start{};
  stream.read(start.data(), start.size());
  if (!stream && stream.gcount() == 0) {
    throw Error(fmt::format(
        "the map's picture {} {}", file.string(),
        std::filesystem::file_size(file, problem) == 0 ? "is empty" : "cannot be read"));
  }
  const std::string_view magic(start.data(), static_cast<std::size_t>(stream.gcount()));
  if (magic.starts_with("\x89PNG")) return open_png(file);
  for (const char* pnm : {"P2", "P3", "P5", "P6"}) {
    if (magic.starts_with(pnm)) return open_pnm(file);
  }
  throw Error(
      fmt::format("the map's picture {} is neither PNG nor PGM nor PPM (P2, P3, P5 or P6): convert "
                  "it to one of them",
                  file.string()));
}

}  // namespace stope::map_source
