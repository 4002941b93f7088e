#include <fmt/format.h>

#include <bit>
#include <cctype>
#include <cstring>
#include <fstream>
#include <limits>
#include <string>
#include <vector>

#include "plugins/map_source/raster_reader.hpp"
#include "stope/error.hpp"

namespace stope::map_source {
namespace {

class PnmReader final : public RasterReader {
 public:
  explicit PnmReader(const std::filesystem::path& file)
      : name_(file.string()), stream_(file, std::ios::binary) {
    if (!stream_) throw Error(fmt::format("the map's picture {} cannot be opened", name_));
    std::string magic(2, ' ');
    stream_.read(magic.data(), 2);
    binary_ = magic == "P5" || magic == "P6";
    if (magic == "P3" || magic == "P6") layout_.channels = 3;
    layout_.width = header_number("width", std::numeric_limits<std::int32_t>::max());
    layout_.height = header_number("height", std::numeric_limits<std::int32_t>::max());
    layout_.max_value = static_cast<unsigned>(header_number("greatest value", 65535));
    layout_.sample_bytes = layout_.max_value > 255 ? 2 : 1;
    stream_.get();  // the one blank between header and samples
    refuse_impossible_size(file);
  }

  const RasterLayout& layout() const override { return layout_; }

  void read_row(std::uint8_t* row) override {
    if (binary_) {
      stream_.read(reinterpret_cast<char*>(row), static_cast<std::streamsize>(layout_.row_bytes()));
      if (!stream_) throw_cut_off();
      if (layout_.sample_bytes == 2) from_big_endian(row);
    } else {
      const std::int64_t samples = std::int64_t{layout_.width} * layout_.channels;
      for (std::int64_t i = 0; i < samples; ++i) put(row, i, plain_sample());
    }
    ++next_;
  }

 private:
  void skip_blanks_and_comments() {
    for (;;) {
      const int c = stream_.peek();
      if (c == '#') {
        stream_.ignore(std::numeric_limits<std::streamsize>::max(), '\n');
      } else if (c != std::char_traits<char>::eof() && std::isspace(c)) {
        stream_.get();
      } else {
        return;
      }
    }
  }

  std::int32_t header_number(const char* what, std::int32_t most) {
    skip_blanks_and_comments();
    std::int64_t number = 0;
    int digits = 0;
    while (std::isdigit(stream_.peek()) && digits < 11) {
      number = 10 * number + (stream_.get() - '0');
      ++digits;
    }
    if (digits == 0 || number < 1 || number > most) {
      throw Error(
          fmt::format("the map's picture {} is not a sound PNM picture: its header gives no {} "
                      "between 1 and {}",
                      name_, what, most));
    }
    return static_cast<std::int32_t>(number);
  }

  unsigned plain_sample() {
    skip_blanks_and_comments();
    unsigned number = 0;
    int digits = 0;
    for (; std::isdigit(stream_.peek()) && digits < 6; ++digits)
      number = 10 * number + static_cast<unsigned>(stream_.get() - '0');
    if (digits == 0) {
      if (stream_.peek() == std::char_traits<char>::eof()) throw_cut_off();
      throw Error(
          fmt::format("the map's picture {} is not a sound PNM picture: row {} holds something "
                      "that is not a number",
                      name_, next_ + 1));
    }
    return std::min(number, layout_.max_value);
  }

  void put(std::uint8_t* row, std::int64_t column, unsigned sample) const {
    if (layout_.sample_bytes == 1) {
      row[column] = static_cast<std::uint8_t>(sample);
    } else {
      const auto wide = static_cast<std::uint16_t>(sample);
      std::memcpy(row + 2 * column, &wide, 2);
    }
  }

  void from_big_endian(std::uint8_t* row) const {
    if constexpr (std::endian::native == std::endian::little) {
      for (std::size_t i = 0; i + 1 < layout_.row_bytes(); i += 2) std::swap(row[i], row[i + 1]);
    }
  }

  // A plain sample takes two bytes at least, with its blank (but for the last).
  void refuse_impossible_size(const std::filesystem::path& file) {
    std::error_code problem;
    const auto bytes = static_cast<double>(std::filesystem::file_size(file, problem));
    const double per_sample = binary_ ? layout_.sample_bytes : 2.0;
    const double needed =
        per_sample * layout_.channels * layout_.width * layout_.height - (binary_ ? 0 : 1);
    if (bytes < needed) {
      throw Error(
          fmt::format("the map's picture {} is cut off: its header says {} x {} pixels, which need "
                      "{:.0f} bytes, and the file has {:.0f}. Copy it again",
                      name_, layout_.width, layout_.height, needed, bytes));
    }
  }

  [[noreturn]] void throw_cut_off() const {
    throw Error(fmt::format("the map's picture {} is cut off in row {} of {}. Copy it again", name_,
                            next_ + 1, layout_.height));
  }

  std::string name_;
  std::ifstream stream_;
  RasterLayout layout_;
  bool binary_ = true;
  std::int32_t next_ = 0;
};

}  // namespace

std::unique_ptr<RasterReader> open_pnm(const std::filesystem::path& file) {
  return std::make_unique<PnmReader>(file);
}

}  // namespace stope::map_source
