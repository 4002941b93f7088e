#pragma once

#include <png.h>

#include <cstdint>
#include <vector>

#include "framework/report/picture.hpp"

namespace stope::made {

/// What a PNG file shows, as libpng's own reader sees it; an empty picture if it cannot.
inline report::Picture decoded_png(const std::vector<std::uint8_t>& bytes) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  if (!png_image_begin_read_from_memory(&image, bytes.data(), bytes.size())) return {};
  image.format = PNG_FORMAT_RGBA;
  report::Picture picture{static_cast<int>(image.width), static_cast<int>(image.height), {}};
  picture.pixels.resize(static_cast<std::size_t>(image.width) * image.height);
  if (!png_image_finish_read(&image, nullptr, picture.pixels.data(), 0, nullptr)) return {};
  return picture;
}

}  // namespace stope::made
