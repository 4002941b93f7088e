#include <png.h>

#include <csetjmp>

#include "plugins/export/canvas.hpp"
#include "stope/error.hpp"

namespace stope::exports {
namespace {

void append(png_structp png, png_bytep data, png_size_t size) {
  auto* bytes = static_cast<std::vector<std::uint8_t>*>(png_get_io_ptr(png));
  bytes->insert(bytes->end(), data, data + size);
}

void flush(png_structp) {}

// libpng reports errors by longjmp: nothing with a destructor may live in here.
bool write_rows(png_structp png, png_infop info, int width, int height, const std::uint8_t* pixels,
                std::vector<std::uint8_t>* bytes) {
  if (setjmp(png_jmpbuf(png))) return false;
  png_set_write_fn(png, bytes, &append, &flush);
  png_set_IHDR(png, info, static_cast<png_uint_32>(width), static_cast<png_uint_32>(height), 8,
               PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
               PNG_FILTER_TYPE_DEFAULT);
  png_set_compression_level(png, 6);
  png_write_info(png, info);
  for (int y = 0; y < height; ++y) {
    png_write_row(png, pixels + 3 * static_cast<std::size_t>(y) * static_cast<std::size_t>(width));
  }
  png_write_end(png, nullptr);
  return true;
}

}  // namespace

std::vector<std::uint8_t> Canvas::png() const {
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png ? png_create_info_struct(png) : nullptr;
  std::vector<std::uint8_t> bytes;
  const bool done = info && write_rows(png, info, width_, height_, pixels_.data(), &bytes);
  png_destroy_write_struct(&png, &info);
  if (!done) throw Error("the picture could not be written as PNG: is there enough memory?");
  return bytes;
}

}  // namespace stope::exports
