#include "plugins/topology/regions/write_labels.hpp"

#include <algorithm>

#include "plugins/topology/for_each_band.hpp"

namespace stope::topology {

void write_labels(const GridFrame& frame, const PaddedGrid<std::int32_t>& names,
                  const std::vector<std::int32_t>& label_of_name, RegionLabels& labels,
                  const Checkpoint& checkpoint) {
  constexpr std::int32_t kBandRows = 64;
  labels.frame = frame;
  std::vector<std::int32_t>& cells = labels.cells.dense();
  cells.resize(frame.size());
  // Cell by cell: to pass over what a tile has in common was slower.
  for_each_band((frame.height + kBandRows - 1) / kBandRows, checkpoint, [&] {
    return [&](std::int32_t band) {
      for (std::int32_t row = band * kBandRows;
           row < std::min(frame.height, (band + 1) * kBandRows); ++row) {
        const std::int32_t* from = names.padded_row(row) + 1;
        std::int32_t* to = cells.data() + frame.place({0, row});
        for (std::int32_t column = 0; column < frame.width; ++column)
          to[column] = label_of_name[static_cast<std::size_t>(from[column])];
      }
    };
  });
}

}  // namespace stope::topology
