#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "framework/report/draw/colour_ramp.hpp"
#include "framework/report/draw/grid_picture.hpp"
#include "framework/report/draw/sketches.hpp"
#include "framework/report/quantity_text.hpp"

namespace stope::report {
namespace {

constexpr std::size_t kLegendEntries = 12;

Raster label_raster(const LabelGrid& grid) {
  return {
      grid.frame,
      grid_picture(grid.frame, grid.cells, [](std::int32_t label) { return label_colour(label); }),
      false};
}

// Which labels from 1 to a few million occur: a bit each, since a noisy grid may hold very many.
std::vector<bool> labels_in(const LabelGrid& grid) {
  constexpr std::int32_t kMostLabels = 1 << 24;
  std::vector<bool> seen;
  for (const std::int32_t label : grid.cells) {
    if (label <= 0 || label >= kMostLabels) continue;
    const auto place = static_cast<std::size_t>(label);
    if (place >= seen.size()) seen.resize(std::max(place + 1, 2 * seen.size()));
    seen[place] = true;
  }
  return seen;
}

std::string css_colour(const Colour& colour) {
  return fmt::format("#{:02x}{:02x}{:02x}", colour[0], colour[1], colour[2]);
}

}  // namespace

Sketch sketch_of(const LabelGrid& grid) {
  Sketch sketch;
  sketch.kind = "Labels";
  if (!is_whole(grid)) {
    sketch.caption = "no cells";
    return sketch;
  }
  const std::vector<bool> seen = labels_in(grid);
  const auto count = static_cast<std::size_t>(std::count(seen.begin(), seen.end(), true));
  sketch.caption =
      fmt::format("{}; {}", grid_size_text(grid.frame), count_text(count, "label", "labels"));
  for (std::size_t label = 1; label < seen.size() && label < grid.names.size(); ++label) {
    if (!seen[label] || sketch.legend.size() == kLegendEntries) continue;
    const Colour colour = label_colour(static_cast<std::int64_t>(label));
    sketch.legend.push_back({"", css_colour(colour), grid.names[label]});
  }
  sketch.raster = label_raster(grid);
  return sketch;
}

}  // namespace stope::report
