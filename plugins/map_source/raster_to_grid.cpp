#include "plugins/map_source/raster_to_grid.hpp"

#include <cstring>
#include <vector>

namespace stope::map_source {
namespace {

unsigned sample_at(const std::uint8_t* row, std::size_t place, int sample_bytes) {
  if (sample_bytes == 1) return row[place];
  std::uint16_t wide = 0;
  std::memcpy(&wide, row + 2 * place, 2);
  return wide;
}

/// Grey without alpha: one look into a table a pixel.
class GreyRows {
 public:
  GreyRows(const RasterLayout& layout, const CellRule& rule)
      : layout_(layout), table_(layout.sample_bytes == 1 ? 256 : 65536) {
    for (std::size_t value = 0; value < table_.size(); ++value) {
      const double shade = static_cast<double>(value) / layout.max_value;
      table_[value] = rule.cell(shade > 1 ? 1 : shade, false);
    }
  }
  void convert(const std::uint8_t* row, std::uint8_t* cells) const {
    const auto width = static_cast<std::size_t>(layout_.width);
    if (layout_.sample_bytes == 1) {
      for (std::size_t i = 0; i < width; ++i) cells[i] = table_[row[i]];
    } else {
      for (std::size_t i = 0; i < width; ++i) cells[i] = table_[sample_at(row, i, 2)];
    }
  }

 private:
  RasterLayout layout_;
  std::vector<std::uint8_t> table_;
};

/// The brightness of a colour is the mean of red, green and blue; in trinary mode alpha counts as a
/// fourth colour, as in nav2.
void convert_colours(const RasterLayout& layout, const CellRule& rule, const std::uint8_t* row,
                     std::uint8_t* cells) {
  const auto channels = static_cast<std::size_t>(layout.channels);
  for (std::size_t i = 0; i < static_cast<std::size_t>(layout.width); ++i) {
    const auto sample = [&](std::size_t channel) {
      return static_cast<double>(sample_at(row, i * channels + channel, layout.sample_bytes));
    };
    double sum = channels <= 2 ? 3 * sample(0) : sample(0) + sample(1) + sample(2);
    double count = 3;
    bool transparent = false;
    if (layout.alpha()) {
      const double alpha = sample(channels - 1);
      transparent = alpha < layout.max_value;
      if (rule.mode == MapMode::kTrinary) sum += alpha, count = 4;
    }
    cells[i] = rule.cell(sum / (count * layout.max_value), transparent);
  }
}

}  // namespace

OccupancyGrid raster_to_grid(RasterReader& raster, const MapYaml& map, Context& context) {
  const RasterLayout& layout = raster.layout();
  OccupancyGrid grid;
  grid.frame = {layout.width, layout.height, map.resolution, map.origin};
  grid.cells.resize(grid.frame.size());
  const bool grey = layout.channels == 1;
  const GreyRows table(layout, map.rule);
  std::vector<std::uint8_t> row(layout.row_bytes());
  for (std::int32_t y = 0; y < layout.height; ++y) {
    raster.read_row(row.data());
    std::uint8_t* cells = grid.cells.data() + grid.frame.place({0, layout.height - 1 - y});
    if (grey) {
      table.convert(row.data(), cells);
    } else {
      convert_colours(layout, map.rule, row.data(), cells);
    }
    if (y % 256 == 255) {
      context.stop_if_cancelled();
      context.progress(static_cast<double>(y + 1) / layout.height);
    }
  }
  return grid;
}

}  // namespace stope::map_source
