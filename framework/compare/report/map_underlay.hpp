#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "framework/compare/report/overlay.hpp"
#include "stope/payloads/grid_frame.hpp"

namespace stope::report {

/// A map that a run saved, as a picture to lie under lines: obstacles grey, unknown ground faint,
/// free ground clear, so that it suits light and dark pages.
struct MapUnderlay {
  GridFrame frame;
  std::vector<std::uint8_t> png;
};

/// Reads a map_server map as export/map_server writes it: the yaml file, and the PGM picture it
/// names. None if either is not there or not of that form.
std::optional<MapUnderlay> read_map(const std::filesystem::path& yaml);

/// Attributes of an SVG <image> that lies on the sheet where the frame does.
struct Placement {
  double x = 0, y = 0, width = 0, height = 0;  ///< units of the sheet, upper left corner
  std::string transform;                       ///< a turn about the frame's corner
};
Placement placement_of(const GridFrame& frame, const Sheet& sheet);

}  // namespace stope::report
