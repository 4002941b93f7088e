#include "plugins/source/synthetic_pit/terrain.hpp"

#include <tbb/blocked_range2d.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "plugins/source/synthetic_pit/noise.hpp"
#include "plugins/source/synthetic_pit/road_field.hpp"
#include "stope/payloads/point_label.hpp"
#include "stope/random.hpp"

namespace stope::source {
namespace {

constexpr double kBermHeight = 1.4;
constexpr double kBermSlope = 1.25;  // of its flanks
constexpr double kRubble = 0.3;      // metres, amplitude of undriven ground
constexpr double kSteep = 0.6;       // rise over run from which ground is a wall
constexpr std::int32_t kTile = 32;

struct Surface {
  const Layout& layout;
  const std::vector<Pad>& pads;
  std::uint64_t seed;

  double berm(double outside, const Vector2& place) const {
    const double width = layout.rules.berm_width;
    const double top =
        kBermHeight * (1 + 0.15 * value_noise(mix_seed(seed, 31), place.x() / 7, place.y() / 7));
    return std::min({top, kBermSlope * outside, kBermSlope * (width - outside)});
  }

  double rubble(double outside, const Vector2& place) const {
    const double share = std::clamp((outside - layout.rules.berm_width) / 2, 0.0, 1.0);
    // Lies in patches, nowhere quite absent.
    const double patch =
        0.6 + 0.5 * value_noise(mix_seed(seed, 33), place.x() / 35, place.y() / 35);
    return share * patch * kRubble *
           fractal_noise(mix_seed(seed, 32), place.x() / 3, place.y() / 3);
  }

  double height(const RoadSample& road, const Vector2& place) const {
    if (road.outside <= 0) return road.level;
    for (const Pad& pad : pads) {
      if (pad.contains(place, 0.6)) return pad.level;
    }
    if (road.outside < layout.rules.berm_width) return road.level + berm(road.outside, place);
    double ground = layout.shape.ground(place);
    // Where banks of two roads disagree the higher road must not slide.
    ground = std::max(std::min(ground, road.upper), road.lower);
    return ground + rubble(road.outside, place);
  }
};

void label_slopes(Terrain& terrain, const Checkpoint& checkpoint) {
  const GridFrame& frame = terrain.frame;
  tbb::parallel_for(0, frame.height, [&](std::int32_t row) {
    checkpoint();
    for (std::int32_t column = 0; column < frame.width; ++column) {
      std::uint8_t& label = terrain.label[frame.place({column, row})];
      if (label != 0) continue;
      const auto at = [&](std::int32_t c, std::int32_t r) {
        c = std::clamp(c, 0, frame.width - 1);
        r = std::clamp(r, 0, frame.height - 1);
        return static_cast<double>(terrain.height[frame.place({c, r})]);
      };
      const double dx = at(column + 1, row) - at(column - 1, row);
      const double dy = at(column, row + 1) - at(column, row - 1);
      const bool steep = std::hypot(dx, dy) > kSteep * 2 * frame.resolution;
      label = static_cast<std::uint8_t>(steep ? PointLabel::kWall : PointLabel::kGround);
    }
  });
}

}  // namespace

bool Pad::contains(const Vector2& place, double grow) const {
  const Vector2 offset = place - centre;
  const double c = std::cos(yaw), s = std::sin(yaw);
  return std::abs(c * offset.x() + s * offset.y()) <= half_length + grow &&
         std::abs(-s * offset.x() + c * offset.y()) <= half_width + grow;
}

double Terrain::height_at(double x, double y) const {
  const double column = std::clamp((x - frame.origin.x) / frame.resolution - 0.5, 0.0,
                                   static_cast<double>(frame.width - 1));
  const double row = std::clamp((y - frame.origin.y) / frame.resolution - 0.5, 0.0,
                                static_cast<double>(frame.height - 1));
  const auto c = std::min(static_cast<std::int32_t>(column), frame.width - 2);
  const auto r = std::min(static_cast<std::int32_t>(row), frame.height - 2);
  const double u = column - c, v = row - r;
  const std::size_t place = frame.place({c, r});
  const auto width = static_cast<std::size_t>(frame.width);
  const double low = (1 - u) * height[place] + u * height[place + 1];
  const double high = (1 - u) * height[place + width] + u * height[place + width + 1];
  return (1 - v) * low + v * high;
}

Terrain build_terrain(const Layout& layout, const PitParameters& parameters,
                      const std::vector<Pad>& pads, std::uint64_t seed,
                      const Checkpoint& checkpoint) {
  Terrain terrain;
  GridFrame& frame = terrain.frame;
  frame.resolution = parameters.resolution;
  frame.width = frame.height =
      static_cast<std::int32_t>(std::ceil(parameters.size / parameters.resolution));
  frame.origin = {-0.5 * frame.width * frame.resolution, -0.5 * frame.height * frame.resolution, 0};
  terrain.height.resize(frame.size());
  terrain.label.assign(frame.size(), 0);
  terrain.drivable.assign(frame.size(), 0);

  const RoadField field(layout, parameters.rough, seed);
  const std::int32_t tiles = (frame.width + kTile - 1) / kTile;
  const auto build_tile = [&](std::int32_t tile_column, std::int32_t tile_row) {
    checkpoint();
    const Vector2 middle = frame.to_map((tile_column + 0.5) * kTile, (tile_row + 0.5) * kTile);
    const double radius = 0.7072 * kTile * frame.resolution;
    const RoadField::Tile tile = field.tile(middle, radius);
    std::vector<Pad> near;
    for (const Pad& pad : pads) {
      if ((pad.centre - middle).norm() < radius + pad.half_length + pad.half_width + 2)
        near.push_back(pad);
    }
    const Surface local{layout, near, seed};
    const std::int32_t last_row = std::min((tile_row + 1) * kTile, frame.height);
    const std::int32_t last_column = std::min((tile_column + 1) * kTile, frame.width);
    for (std::int32_t row = tile_row * kTile; row < last_row; ++row) {
      for (std::int32_t column = tile_column * kTile; column < last_column; ++column) {
        const Vector2 place = frame.centre({column, row});
        const RoadSample road = field.sample(tile, place);
        const std::size_t cell = frame.place({column, row});
        terrain.height[cell] = static_cast<float>(local.height(road, place));
        terrain.drivable[cell] = road.outside < 0 ? 1 : 0;
        if (road.outside <= 0) {
          terrain.label[cell] = static_cast<std::uint8_t>(PointLabel::kGround);
        } else if (road.outside < layout.rules.berm_width) {
          terrain.label[cell] = static_cast<std::uint8_t>(PointLabel::kBerm);
        }
      }
    }
  };
  tbb::parallel_for(tbb::blocked_range2d<std::int32_t>(0, tiles, 0, tiles), [&](const auto& range) {
    for (std::int32_t row = range.rows().begin(); row < range.rows().end(); ++row) {
      for (std::int32_t column = range.cols().begin(); column < range.cols().end(); ++column)
        build_tile(column, row);
    }
  });
  label_slopes(terrain, checkpoint);
  return terrain;
}

}  // namespace stope::source
