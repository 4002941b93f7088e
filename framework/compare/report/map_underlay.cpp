#include "framework/compare/report/map_underlay.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <fstream>
#include <numbers>
#include <sstream>

#include "framework/report/draw/grid_picture.hpp"
#include "framework/report/draw/png.hpp"

namespace stope::report {
namespace {

constexpr int kMostCellsAcross = 1 << 16;
constexpr std::uint8_t kFreeFrom = 250, kOccupiedTo = 100;  // of a trinary map's 254, 205 and 0

/// What stands behind a key at the beginning of a line; empty if it does not stand there.
std::string value_of(const std::string& text, const std::string& key) {
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with(key + ": ")) return line.substr(key.size() + 2);
  return {};
}

bool read_frame(const std::string& text, GridFrame& frame) {
  return std::sscanf(value_of(text, "resolution").c_str(), "%lf", &frame.resolution) == 1 &&
         std::sscanf(value_of(text, "origin").c_str(), "[%lf, %lf, %lf]", &frame.origin.x,
                     &frame.origin.y, &frame.origin.yaw) == 3 &&
         frame.resolution > 0;
}

/// The picture's cells, lowest row first.
bool read_cells(const std::filesystem::path& pgm, GridFrame& frame,
                std::vector<std::uint8_t>& cells) {
  std::ifstream file(pgm, std::ios::binary);
  std::string magic;
  int most = 0;
  if (!(file >> magic >> frame.width >> frame.height >> most) || magic != "P5" || most != 255 ||
      frame.width <= 0 || frame.height <= 0 || frame.width > kMostCellsAcross ||
      frame.height > kMostCellsAcross)
    return false;
  file.get();
  cells.resize(frame.size());
  for (std::int32_t row = frame.height; row-- > 0;)
    file.read(reinterpret_cast<char*>(cells.data() + frame.place({0, row})), frame.width);
  return static_cast<bool>(file);
}

Colour colour_of(std::uint8_t pixel) {
  if (pixel >= kFreeFrom) return {0, 0, 0, 0};
  return {122, 130, 140, static_cast<std::uint8_t>(pixel <= kOccupiedTo ? 120 : 40)};
}

}  // namespace

std::optional<MapUnderlay> read_map(const std::filesystem::path& yaml) {
  std::ifstream file(yaml, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  MapUnderlay map;
  std::vector<std::uint8_t> cells;
  if (!read_frame(text.str(), map.frame) ||
      !read_cells(yaml.parent_path() / value_of(text.str(), "image"), map.frame, cells))
    return std::nullopt;
  map.png = encode_png(grid_picture(map.frame, cells, colour_of));
  return map;
}

Placement placement_of(const GridFrame& frame, const Sheet& sheet) {
  const double units = sheet.width / (sheet.extent.high.x() - sheet.extent.low.x());
  const double left = (frame.origin.x - sheet.extent.low.x()) * units;
  const double bottom = (sheet.extent.high.y() - frame.origin.y) * units;
  const double height = frame.height * frame.resolution * units;
  Placement placement{left, bottom - height, frame.width * frame.resolution * units, height, {}};
  // Counter-clockwise on the map is clockwise for SVG, whose y points down.
  if (frame.origin.yaw != 0)
    placement.transform = fmt::format("rotate({:.4f} {:.2f} {:.2f})",
                                      -frame.origin.yaw * 180 / std::numbers::pi, left, bottom);
  return placement;
}

}  // namespace stope::report
