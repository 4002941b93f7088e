#include "plugins/source/synthetic_pit/machines.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "stope/random.hpp"

namespace stope::source {
namespace {

/// Length, width, and the boxes' (forward, half length, half width, bottom, top).
struct Model {
  double length, width;
  std::array<std::array<double, 5>, 3> parts;
};

// The mass of each machine, not its looks: chassis, body, cab.
constexpr std::array<Model, 3> kModels{
    Model{9.2,
          4.4,
          {{{0, 4.4, 1.7, 0.5, 2.0}, {-0.9, 3.5, 2.1, 2.0, 4.6}, {3.3, 1.1, 1.6, 2.0, 3.9}}}},
    Model{7.6,
          4.2,
          {{{0, 3.3, 2.1, 0.0, 1.4}, {-0.5, 2.4, 1.7, 1.4, 3.6}, {2.4, 1.4, 0.5, 1.4, 3.0}}}},
    Model{5.4,
          2.2,
          {{{0, 2.6, 1.0, 0.3, 1.0}, {-0.2, 1.3, 0.9, 1.0, 1.9}, {-1.9, 0.6, 1.0, 1.0, 1.4}}}}};

}  // namespace

double Box::cast(const Vector3& origin, const Vector3& direction) const {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const double c = std::cos(yaw), s = std::sin(yaw);
  const Vector3 offset = origin - centre;
  const std::array<double, 3> at{c * offset.x() + s * offset.y(), -s * offset.x() + c * offset.y(),
                                 offset.z()};
  const std::array<double, 3> speed{c * direction.x() + s * direction.y(),
                                    -s * direction.x() + c * direction.y(), direction.z()};
  double enter = 0, leave = kInfinity;
  for (int axis = 0; axis < 3; ++axis) {
    if (speed[axis] == 0) {
      if (std::abs(at[axis]) > half[axis]) return kInfinity;
      continue;
    }
    const double first = (-half[axis] - at[axis]) / speed[axis];
    const double second = (half[axis] - at[axis]) / speed[axis];
    enter = std::max(enter, std::min(first, second));
    leave = std::min(leave, std::max(first, second));
  }
  return enter <= leave && enter > 0 ? enter : kInfinity;
}

Machines park_machines(const Layout& layout, const PitParameters& parameters, std::uint64_t seed) {
  Machines machines;
  for (std::size_t i = 0; i < layout.network.dead_ends.size(); ++i) {
    const DeadEnd& end = layout.network.dead_ends[i];
    Random random(mix_seed(mix_seed(seed, 40), i));
    const Vector2 centre = layout.network.centre(end), heading = layout.network.heading(end);
    const double ahead = std::atan2(heading.y(), heading.x());
    const auto wanted = static_cast<int>(parameters.objects + random.uniform());
    std::vector<double> taken;
    for (int attempt = 0; attempt < 20 && static_cast<int>(taken.size()) < wanted; ++attempt) {
      const double angle = random.uniform(-1.7, 1.7);  // not in the mouth of the road
      const Model& model = kModels[random.below(kModels.size())];
      const double room = 8.0 / end.radius;
      if (std::any_of(taken.begin(), taken.end(),
                      [&](double other) { return std::abs(other - angle) < room; }))
        continue;
      taken.push_back(angle);
      Pad pad;
      pad.yaw = ahead + angle;
      const Vector2 forward(std::cos(pad.yaw), std::sin(pad.yaw));
      pad.half_length = 0.5 * model.length;
      pad.half_width = 0.5 * model.width;
      pad.centre = centre + (end.radius + parameters.rough + 0.2 + pad.half_length) * forward;
      pad.level = layout.network.elevation(end);
      for (const auto& [along, half_length, half_width, bottom, top] : model.parts) {
        const Vector2 middle = pad.centre - along * forward;  // it looks into the place
        machines.boxes.push_back({{middle.x(), middle.y(), pad.level + 0.5 * (bottom + top)},
                                  {half_length, half_width, 0.5 * (top - bottom)},
                                  pad.yaw});
      }
      machines.pads.push_back(pad);
    }
  }
  return machines;
}

}  // namespace stope::source
