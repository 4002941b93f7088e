#include "plugins/source/synthetic_pit/street_network.hpp"

#include <algorithm>
#include <utility>

#include "plugins/source/synthetic_pit/curve.hpp"

namespace stope::source {

double Street::length() const {
  return station.back() + (closed ? (points.front() - points.back()).norm() : 0.0);
}

Vector2 Street::direction(std::size_t point) const {
  const std::size_t n = points.size();
  const std::size_t before = closed ? (point + n - 1) % n : point - std::min<std::size_t>(point, 1);
  const std::size_t after = closed ? (point + 1) % n : std::min(point + 1, n - 1);
  return (points[after] - points[before]).normalized();
}

Vector2 StreetNetwork::centre(const DeadEnd& end) const {
  const Street& street = streets[end.street];
  return end.at_end ? street.points.back() : street.points.front();
}

double StreetNetwork::elevation(const DeadEnd& end) const {
  const Street& street = streets[end.street];
  return end.at_end ? street.elevation.back() : street.elevation.front();
}

Vector2 StreetNetwork::heading(const DeadEnd& end) const {
  const Street& street = streets[end.street];
  if (end.at_end) return street.direction(street.points.size() - 1);
  return -street.direction(0);
}

Street make_street(std::vector<Vector2> points, double width, bool closed) {
  Street street;
  street.station = stations(points);
  street.elevation.assign(points.size(), 0.0);
  street.points = std::move(points);
  street.width = width;
  street.closed = closed;
  return street;
}

}  // namespace stope::source
