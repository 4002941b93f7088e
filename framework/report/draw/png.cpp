#include "framework/report/draw/png.hpp"

#include <png.h>

#include <algorithm>
#include <array>
#include <map>
#include <string>

#include "stope/error.hpp"

namespace stope::report {
namespace {

struct Palette {
  std::vector<Colour> colours;        ///< ordered: those with transparency first
  std::vector<std::uint8_t> indices;  ///< as the picture's pixels
};

// The palette of a picture, or an empty one if it has more than 256 colours.
Palette palette_of(const Picture& picture) {
  std::map<Colour, std::uint8_t> places;
  for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
    if (i > 0 && picture.pixels[i] == picture.pixels[i - 1]) continue;
    places.emplace(picture.pixels[i], std::uint8_t{0});
    if (places.size() > 256) return {};
  }
  Palette palette;
  for (const auto& entry : places) palette.colours.push_back(entry.first);
  // PNG stores opacity only up to the last entry that needs it.
  std::stable_sort(palette.colours.begin(), palette.colours.end(),
                   [](const Colour& a, const Colour& b) { return a[3] < b[3]; });
  for (std::size_t i = 0; i < palette.colours.size(); ++i)
    places[palette.colours[i]] = static_cast<std::uint8_t>(i);
  palette.indices.reserve(picture.pixels.size());
  for (const Colour& colour : picture.pixels) {
    const std::size_t i = palette.indices.size();
    palette.indices.push_back(i > 0 && colour == picture.pixels[i - 1] ? palette.indices.back()
                                                                       : places[colour]);
  }
  return palette;
}

[[noreturn]] void throw_error(png_structp, png_const_charp message) {
  throw Error(std::string("libpng cannot encode a picture of the report: ") + message);
}

void append(png_structp png, png_bytep data, png_size_t size) {
  auto& bytes = *static_cast<std::vector<std::uint8_t>*>(png_get_io_ptr(png));
  bytes.insert(bytes.end(), data, data + size);
}

void set_palette(png_structp png, png_infop info, const Palette& palette) {
  std::array<png_color, 256> colours{};
  std::array<png_byte, 256> opacity{};
  int transparent = 0;
  for (std::size_t i = 0; i < palette.colours.size(); ++i) {
    const Colour& colour = palette.colours[i];
    colours[i] = {colour[0], colour[1], colour[2]};
    opacity[i] = colour[3];
    if (colour[3] < 255) transparent = static_cast<int>(i) + 1;
  }
  png_set_PLTE(png, info, colours.data(), static_cast<int>(palette.colours.size()));
  if (transparent > 0) png_set_tRNS(png, info, opacity.data(), transparent, nullptr);
}

}  // namespace

std::vector<std::uint8_t> encode_png(const Picture& picture) {
  std::vector<std::uint8_t> bytes;
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, &throw_error, nullptr);
  if (!png) throw Error("libpng cannot be started: there was not enough memory.");
  png_infop info = png_create_info_struct(png);
  try {
    if (!info) throw Error("libpng cannot be started: there was not enough memory.");
    const Palette palette = palette_of(picture);
    const bool indexed = !palette.colours.empty();
    png_set_write_fn(png, &bytes, &append, nullptr);
    png_set_IHDR(png, info, static_cast<png_uint_32>(picture.width),
                 static_cast<png_uint_32>(picture.height), 8,
                 indexed ? PNG_COLOR_TYPE_PALETTE : PNG_COLOR_TYPE_RGBA, PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    // All that could make the bytes depend on libpng's defaults is said here.
    png_set_filter(png, 0, indexed ? PNG_FILTER_NONE : PNG_FILTER_SUB);
    png_set_compression_level(png, 6);
    if (indexed) set_palette(png, info, palette);
    png_write_info(png, info);
    const std::size_t stride = static_cast<std::size_t>(picture.width) * (indexed ? 1 : 4);
    const auto* rows = indexed ? palette.indices.data()
                               : reinterpret_cast<const std::uint8_t*>(picture.pixels.data());
    for (int row = 0; row < picture.height; ++row)
      png_write_row(png, rows + static_cast<std::size_t>(row) * stride);
    png_write_end(png, info);
  } catch (...) {
    png_destroy_write_struct(&png, &info);
    throw;
  }
  png_destroy_write_struct(&png, &info);
  return bytes;
}

}  // namespace stope::report
