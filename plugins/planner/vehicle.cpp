#include "plugins/planner/vehicle.hpp"

#include <fmt/format.h>

#include "stope/error.hpp"

namespace stope::planner {

void check_vehicle(const Vehicle& vehicle) {
  const bool finite = std::isfinite(vehicle.length) && std::isfinite(vehicle.width) &&
                      std::isfinite(vehicle.rear_overhang) && std::isfinite(vehicle.wheelbase) &&
                      std::isfinite(vehicle.turning_radius) && std::isfinite(vehicle.max_grade) &&
                      std::isfinite(vehicle.margin) && std::isfinite(vehicle.steering_distance);
  if (!finite)
    throw Error("a size of the truck is not a finite number: give all of them in metres");
  const double least = vehicle.least_turning_radius();
  if (vehicle.turning_radius < least) {
    throw Error(fmt::format(
        "turning_radius is {} m, but a truck {:.2f} m wide and {:.2f} m long cannot turn with less "
        "than {:.2f} m, half its width or a tenth of its length: give the radius of the way that "
        "the middle of its rear axle takes at full lock, in metres",
        vehicle.turning_radius, vehicle.width, vehicle.length, least));
  }
  if (vehicle.rear_overhang + vehicle.wheelbase > vehicle.length) {
    throw Error(fmt::format(
        "rear_overhang ({:.2f} m) and wheelbase ({:.2f} m) together are longer than the truck "
        "({:.2f} m): the front axle would lie before its nose",
        vehicle.rear_overhang, vehicle.wheelbase, vehicle.length));
  }
}

}  // namespace stope::planner
