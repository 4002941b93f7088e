#include "plugins/export/cone_colour.hpp"

#include "stope/payloads/occupancy_grid.hpp"

namespace stope::exports {
namespace {

constexpr int kUnknownValue = 205;

/// Eqs. 7 and 8 with V = `value` and chroma = V·OM, in whole steps of 1/255.
Rgb cone(int degrees, int value, int chroma) {
  const int sector = degrees / 60, within = degrees % 60;
  const int least = value - chroma;
  // (1 - f) of the way down in even sectors, f in odd ones; rounded half up.
  const int down = sector % 2 == 0 ? 60 - within : within;
  const int middle = value - (2 * down * chroma + 60) / 120;
  const auto v = static_cast<std::uint8_t>(value), p = static_cast<std::uint8_t>(least);
  const auto m = static_cast<std::uint8_t>(middle);
  switch (sector) {
    case 0:
      return {v, m, p};
    case 1:
      return {m, v, p};
    case 2:
      return {p, v, m};
    case 3:
      return {p, m, v};
    case 4:
      return {m, p, v};
    default:
      return {v, p, m};
  }
}

}  // namespace

ConeColours::ConeColours(int floor, int hues) : floor_(floor), hues_(hues) {}

Rgb ConeColours::region(int hue, std::uint8_t cell) const {
  const int degrees = hue * (360 / hues_);
  if (cell == OccupancyGrid::kUnknown)
    return cone(degrees, kUnknownValue, kUnknownValue * (floor_ + 255) / 510);
  const auto chroma = [&](int value) { return floor_ + value * (255 - floor_) / 254; };
  const bool second = cell > 0 && chroma(cell - 1) == chroma(cell);
  return cone(degrees, second ? 254 : 255, chroma(cell));
}

Rgb ConeColours::grey(std::uint8_t cell) {
  int shade = kUnknownValue;
  if (cell != OccupancyGrid::kUnknown) shade = 255 - cell > kUnknownValue ? 255 - cell : 254 - cell;
  const auto grey = static_cast<std::uint8_t>(shade);
  return {grey, grey, grey};
}

}  // namespace stope::exports
