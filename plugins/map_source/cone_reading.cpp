#include "plugins/map_source/cone_reading.hpp"

#include <algorithm>
#include <cmath>

#include "stope/payloads/occupancy_grid.hpp"

namespace stope::map_source {
namespace {

constexpr int kUnknownValue = 205;

std::uint32_t key_of(const Rgb& colour) {
  return (std::uint32_t{colour[0]} << 16U) | (std::uint32_t{colour[1]} << 8U) | colour[2];
}

/// Eqs. 7 and 8 in whole steps of 1/255, rounded half up.
Rgb cone(int degrees, int value, int chroma) {
  const int sector = degrees / 60, within = degrees % 60;
  const int down = sector % 2 == 0 ? 60 - within : within;
  const auto top = static_cast<std::uint8_t>(value);
  const auto least = static_cast<std::uint8_t>(value - chroma);
  const auto middle = static_cast<std::uint8_t>(value - (2 * down * chroma + 60) / 120);
  constexpr std::array<std::array<int, 3>, 6> kOrder{
      {{0, 1, 2}, {1, 0, 2}, {2, 0, 1}, {2, 1, 0}, {1, 2, 0}, {0, 2, 1}}};
  const std::array<std::uint8_t, 3> parts{top, middle, least};
  Rgb colour{};
  for (std::size_t channel = 0; channel < 3; ++channel)
    colour[channel] =
        parts[static_cast<std::size_t>(kOrder[static_cast<std::size_t>(sector)][channel])];
  return colour;
}

}  // namespace

StopeCone::StopeCone(int floor, int step) {
  for (int cell = 0; cell < 255; ++cell) {
    const auto value = static_cast<std::uint8_t>(cell);
    const int shade = 255 - cell > kUnknownValue ? 255 - cell : 254 - cell;
    const auto grey = static_cast<std::uint8_t>(shade);
    colours_[key_of({grey, grey, grey})] = {-1, value, true};
    const auto chroma = [&](int v) { return floor + v * (255 - floor) / 254; };
    const bool second = cell > 0 && chroma(cell - 1) == chroma(cell);
    for (int hue = 0; hue < 360 / step; ++hue) {
      const Rgb colour = cone(hue * step, second ? 254 : 255, chroma(cell));
      colours_[key_of(colour)] = {static_cast<std::int16_t>(hue), value, true};
    }
  }
  const std::uint8_t unknown = OccupancyGrid::kUnknown, grey = kUnknownValue;
  colours_[key_of({grey, grey, grey})] = {-1, unknown, true};
  for (int hue = 0; hue < 360 / step; ++hue) {
    const Rgb colour = cone(hue * step, kUnknownValue, kUnknownValue * (floor + 255) / 510);
    colours_[key_of(colour)] = {static_cast<std::int16_t>(hue), unknown, true};
  }
}

ConePixel StopeCone::read(const Rgb& colour) const {
  const auto found = colours_.find(key_of(colour));
  return found == colours_.end() ? ConePixel{-1, 0, false} : found->second;
}

ConePixel PaperCone::read(const Rgb& colour) const {
  const int red = colour[0], green = colour[1], blue = colour[2];
  const int top = std::max({red, green, blue}), least = std::min({red, green, blue});
  const int chroma = top - least;
  const double saturation = top == 0 ? 0 : static_cast<double>(chroma) / top;
  // CellRule reads brightness, which is what is not occupied.
  const double probability = std::min(1.0, saturation / coefficient_);
  ConePixel pixel;
  pixel.cell = rule_.mode == MapMode::kRaw
                   ? static_cast<std::uint8_t>(std::lround(probability * OccupancyGrid::kOccupied))
                   : rule_.cell(1 - probability, false);
  // Eq. 10 divides by V; with fewer than three steps of chroma 20 degrees cannot be told apart.
  if (chroma * step_ < 60) return pixel;
  const double delta = chroma;
  double hue = top == red     ? 60.0 * (green - blue) / delta
               : top == green ? 120 + 60.0 * (blue - red) / delta
                              : 240 + 60.0 * (red - green) / delta;
  if (hue < 0) hue += 360;
  const int count = std::max(1, 360 / step_);
  const auto number = static_cast<int>(std::lround((hue - start_) / step_));
  pixel.hue = static_cast<std::int16_t>(((number % count) + count) % count);
  return pixel;
}

}  // namespace stope::map_source
