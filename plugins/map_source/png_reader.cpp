#include <fmt/format.h>
#include <png.h>

#include <bit>
#include <csetjmp>
#include <cstdio>
#include <cstring>
#include <string>
#include <vector>

#include "plugins/map_source/raster_reader.hpp"
#include "stope/error.hpp"

namespace stope::map_source {
namespace {

/// libpng reports errors by longjmp. Every call into it therefore stands in a method that sets the
/// jump, holds no object with a destructor, and returns false; the exception is thrown above it.
class PngReader final : public RasterReader {
 public:
  explicit PngReader(const std::filesystem::path& file) : name_(file.string()) {
    file_.reset(std::fopen(name_.c_str(), "rb"));
    if (!file_) throw Error(fmt::format("the map's picture {} cannot be opened", name_));
    handles_.png =
        png_create_read_struct(PNG_LIBPNG_VER_STRING, this, &PngReader::fail, &PngReader::warn);
    if (handles_.png) handles_.info = png_create_info_struct(handles_.png);
    if (!handles_.info || !read_header()) throw_broken("its header", reason_);
    refuse_impossible_size();
    if (passes_ > 1) read_interlaced();
  }
  PngReader(const PngReader&) = delete;
  PngReader& operator=(const PngReader&) = delete;

  const RasterLayout& layout() const override { return layout_; }

  void read_row(std::uint8_t* row) override {
    if (!whole_.empty()) {
      std::memcpy(row, whole_.data() + static_cast<std::size_t>(next_) * layout_.row_bytes(),
                  layout_.row_bytes());
    } else if (!read_png_row(row)) {
      throw_broken(fmt::format("row {} of {}", next_ + 1, layout_.height), reason_);
    }
    ++next_;
  }

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };

  static void fail(png_structp png, png_const_charp reason) {
    auto* reader = static_cast<PngReader*>(png_get_error_ptr(png));
    std::snprintf(reader->reason_, sizeof(reader->reason_), "%s", reason);
    longjmp(png_jmpbuf(png), 1);
  }
  static void warn(png_structp, png_const_charp) {}

  bool read_header() {
    if (setjmp(png_jmpbuf(handles_.png))) return false;
    png_init_io(handles_.png, file_.get());
    png_read_info(handles_.png, handles_.info);
    // Palettes to RGB, 1, 2 and 4 bits to 8, transparent colours to alpha.
    png_set_expand(handles_.png);
    if constexpr (std::endian::native == std::endian::little) png_set_swap(handles_.png);
    passes_ = png_set_interlace_handling(handles_.png);
    png_read_update_info(handles_.png, handles_.info);
    layout_.width = static_cast<std::int32_t>(png_get_image_width(handles_.png, handles_.info));
    layout_.height = static_cast<std::int32_t>(png_get_image_height(handles_.png, handles_.info));
    layout_.channels = png_get_channels(handles_.png, handles_.info);
    layout_.sample_bytes = png_get_bit_depth(handles_.png, handles_.info) == 16 ? 2 : 1;
    layout_.max_value = layout_.sample_bytes == 2 ? 65535 : 255;
    return true;
  }

  bool read_png_row(std::uint8_t* row) {
    if (setjmp(png_jmpbuf(handles_.png))) return false;
    png_read_row(handles_.png, row, nullptr);
    return true;
  }

  bool read_png_image(png_bytepp rows) {
    if (setjmp(png_jmpbuf(handles_.png))) return false;
    png_read_image(handles_.png, rows);
    return true;
  }

  // Deflate packs at most 1032 to 1: a header that promises more than the file can hold is damaged,
  // and must not make us ask for that much memory.
  void refuse_impossible_size() const {
    std::error_code problem;
    const double bytes = static_cast<double>(std::filesystem::file_size(name_, problem));
    const double bits =
        png_get_bit_depth(handles_.png, handles_.info) == 8 ? 1 : 8;  // 1 bit before expansion
    const double promised = static_cast<double>(layout_.width) * layout_.height * bits / 8;
    if (promised > 1100.0 * bytes + 65536) {
      throw Error(
          fmt::format("the map's picture {} says it has {} x {} pixels, but its {} bytes cannot "
                      "hold that many: it is cut off or damaged",
                      name_, layout_.width, layout_.height, static_cast<std::size_t>(bytes)));
    }
  }

  void read_interlaced() {
    whole_.resize(layout_.row_bytes() * static_cast<std::size_t>(layout_.height));
    std::vector<png_bytep> rows(static_cast<std::size_t>(layout_.height));
    for (std::size_t i = 0; i < rows.size(); ++i) rows[i] = whole_.data() + i * layout_.row_bytes();
    if (!read_png_image(rows.data())) throw_broken("an interlaced pass", reason_);
  }

  [[noreturn]] void throw_broken(const std::string& where, const std::string& reason) const {
    throw Error(fmt::format(
        "the map's picture {} is cut off or damaged: PNG cannot be read at {} ({}). Copy the file "
        "again",
        name_, where, reason.empty() ? "no reason given" : reason));
  }

  std::string name_;
  std::unique_ptr<std::FILE, Close> file_;
  /// Closed also where the constructor throws.
  struct Handles {
    Handles() = default;
    ~Handles() { png_destroy_read_struct(&png, &info, nullptr); }
    Handles(const Handles&) = delete;
    Handles& operator=(const Handles&) = delete;
    png_structp png = nullptr;
    png_infop info = nullptr;
  } handles_;
  RasterLayout layout_;
  int passes_ = 1;
  std::int32_t next_ = 0;
  std::vector<std::uint8_t> whole_;  // of an interlaced picture only
  char reason_[160] = "";
};

}  // namespace

std::unique_ptr<RasterReader> open_png(const std::filesystem::path& file) {
  return std::make_unique<PngReader>(file);
}

}  // namespace stope::map_source
