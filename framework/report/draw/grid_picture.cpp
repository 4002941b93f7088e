#include "framework/report/draw/grid_picture.hpp"

#include <fmt/format.h>

#include "framework/report/quantity_text.hpp"

namespace stope::report {

Blocks::Blocks(const GridFrame& frame, int longest) : columns(frame.width), rows(frame.height) {
  const int side = std::max(columns, rows);
  const auto fit = [&](int cells) {
    return side <= longest ? cells : std::max(1, scaled(cells, longest, side));
  };
  picture_width = fit(columns);
  picture_height = fit(rows);
}

std::string grid_size_text(const GridFrame& frame) {
  return fmt::format(
      "{} × {} cells of {}, {} × {}", count_text(static_cast<std::uint64_t>(frame.width)),
      count_text(static_cast<std::uint64_t>(frame.height)), length_text(frame.resolution),
      length_text(frame.width * frame.resolution), length_text(frame.height * frame.resolution));
}

}  // namespace stope::report
