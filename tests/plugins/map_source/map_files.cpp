#include "tests/plugins/map_source/map_files.hpp"

#include <png.h>
#include <stdlib.h>

#include <cstdio>
#include <fstream>
#include <stdexcept>

namespace stope::map_source {

MapFolder::MapFolder() {
  std::string name = (std::filesystem::temp_directory_path() / "stope-map-XXXXXX").string();
  if (!::mkdtemp(name.data())) throw std::runtime_error("cannot make " + name);
  path_ = name;
}

MapFolder::~MapFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

std::filesystem::path MapFolder::write(const std::string& name, const std::string& bytes) const {
  const auto file = path_ / name;
  std::ofstream(file, std::ios::binary) << bytes;
  return file;
}

std::filesystem::path MapFolder::write_yaml(const std::string& image,
                                            const std::string& more) const {
  return write("map.yaml", "image: " + image +
                               "\nresolution: 0.5\norigin: [10, 20, 0.25]\nnegate: 0\n"
                               "occupied_thresh: 0.65\nfree_thresh: 0.196\n" +
                               more);
}

std::filesystem::path MapFolder::write_png(const std::string& name, int width, int height,
                                           int depth, int colour_type,
                                           const std::vector<std::uint8_t>& samples,
                                           bool interlaced) const {
  const auto file = path_ / name;
  std::FILE* out = std::fopen(file.c_str(), "wb");
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(png);
  png_init_io(png, out);
  png_set_IHDR(png, info, static_cast<png_uint_32>(width), static_cast<png_uint_32>(height), depth,
               colour_type, interlaced ? PNG_INTERLACE_ADAM7 : PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  if (colour_type == PNG_COLOR_TYPE_PALETTE) {
    const png_color palette[] = {{0, 0, 0}, {255, 255, 255}, {205, 205, 205}};
    png_set_PLTE(png, info, palette, 3);
  }
  png_write_info(png, info);
  if (depth < 8) png_set_packing(png);
  std::vector<png_bytep> rows;
  const std::size_t stride = samples.size() / static_cast<std::size_t>(height);
  for (int y = 0; y < height; ++y) {
    rows.push_back(const_cast<png_bytep>(samples.data() + static_cast<std::size_t>(y) * stride));
  }
  png_write_image(png, rows.data());
  png_write_end(png, nullptr);
  png_destroy_write_struct(&png, &info);
  std::fclose(out);
  return file;
}

}  // namespace stope::map_source
