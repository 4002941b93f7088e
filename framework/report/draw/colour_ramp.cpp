#include "framework/report/draw/colour_ramp.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "stope/payloads/occupancy_grid.hpp"

namespace stope::report {

Colour ColourRamp::at(double fraction) const {
  const double place = std::clamp(fraction, 0.0, 1.0) * static_cast<double>(stops.size() - 1);
  const std::size_t below = std::min(static_cast<std::size_t>(place), stops.size() - 2);
  const double part = place - static_cast<double>(below);
  Colour colour{};
  for (std::size_t k = 0; k < colour.size(); ++k)
    colour[k] = static_cast<std::uint8_t>(
        std::lround((1 - part) * stops[below][k] + part * stops[below + 1][k]));
  return colour;
}

const ColourRamp& height_ramp() {
  static const ColourRamp ramp{{{46, 74, 98, 255},
                                {78, 121, 116, 255},
                                {151, 163, 117, 255},
                                {211, 189, 130, 255},
                                {193, 138, 94, 255},
                                {236, 224, 208, 255}}};
  return ramp;
}

const ColourRamp& distance_ramp() {
  static const ColourRamp ramp{
      {{236, 243, 247, 255}, {158, 202, 219, 255}, {74, 146, 185, 255}, {21, 74, 124, 255}}};
  return ramp;
}

const ColourRamp& point_ramp() {
  static const ColourRamp ramp{{{59, 76, 158, 255},
                                {44, 127, 158, 255},
                                {47, 160, 120, 255},
                                {154, 176, 60, 255},
                                {226, 156, 48, 255},
                                {205, 84, 50, 255}}};
  return ramp;
}

Colour label_colour(std::int64_t label) {
  static constexpr std::array<Colour, 12> kColours{{{106, 153, 193, 255},
                                                    {226, 165, 96, 255},
                                                    {127, 178, 133, 255},
                                                    {206, 120, 118, 255},
                                                    {155, 138, 191, 255},
                                                    {196, 178, 112, 255},
                                                    {104, 181, 186, 255},
                                                    {214, 146, 178, 255},
                                                    {140, 156, 92, 255},
                                                    {122, 134, 160, 255},
                                                    {233, 193, 144, 255},
                                                    {163, 203, 196, 255}}};
  if (label == 0) return {0, 0, 0, 0};
  const std::int64_t count = static_cast<std::int64_t>(kColours.size());
  return kColours[static_cast<std::size_t>(((label - 1) % count + count) % count)];
}

Colour occupancy_colour(std::uint8_t value) {
  constexpr int kWhite = 255, kDark = 166, kPale = 226;
  std::uint8_t grey = kPale;
  if (value != OccupancyGrid::kUnknown)
    grey = static_cast<std::uint8_t>(kWhite - (kWhite - kDark) * value / 254);
  return {grey, grey, grey, 255};
}

}  // namespace stope::report
