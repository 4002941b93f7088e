#include "framework/compare/report/overlay.hpp"

#include <fmt/format.h>

#include <cmath>
#include <iterator>

#include "framework/report/draw/simplify.hpp"

namespace stope::report {
namespace {

std::string path_of(const Lines& lines, const Sheet& sheet) {
  const double units = sheet.width / (sheet.extent.high.x() - sheet.extent.low.x());
  std::string d;
  for (const auto& line : lines) {
    const char* step = "M";
    // A quarter of a unit: nobody sees it, and the page stays light.
    for (const Vector2& point : simplified(line, 0.25 / units)) {
      fmt::format_to(std::back_inserter(d), "{}{:.1f} {:.1f}", step,
                     (point.x() - sheet.extent.low.x()) * units,
                     (sheet.extent.high.y() - point.y()) * units);
      step = "L";
    }
  }
  return d;
}

}  // namespace

Sheet sheet_for(const std::vector<Lines>& drawings) {
  Sheet sheet;
  for (const Lines& lines : drawings) sheet.extent.include(lines);
  if (sheet.extent.empty()) return sheet;
  sheet.tolerance = drawing_tolerance(sheet.extent.diagonal());
  // A margin, and neither side so short that the sheet becomes a thread.
  const Vector2 size = sheet.extent.high - sheet.extent.low;
  const Vector2 middle = (sheet.extent.high + sheet.extent.low) / 2;
  const double longest = std::max(size.maxCoeff(), 1e-3);
  const Vector2 half = (size.array().max(0.3 * longest) + 0.08 * longest).matrix() / 2;
  sheet.extent.low = middle - half;
  sheet.extent.high = middle + half;
  sheet.height = sheet.width * half.y() / half.x();
  return sheet;
}

Overlay overlay_of(const Lines& first, const Lines& second, const Sheet& sheet) {
  if (sheet.extent.empty()) return {};
  const LineDifference difference = line_difference(first, second, sheet.tolerance);
  return {path_of(difference.common, sheet),      path_of(difference.only_first, sheet),
          path_of(difference.only_second, sheet), length_of(difference.common),
          length_of(difference.only_first),       length_of(difference.only_second)};
}

}  // namespace stope::report
