#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>

#include "framework/compare/report/line_difference.hpp"

namespace stope::report {
namespace {

using Json = nlohmann::json;
using Place = std::pair<double, double>;

std::string type_of(const Json& json) {
  const auto found = json.find("type");
  return found != json.end() && found->is_string() ? found->get<std::string>() : std::string();
}

void read_line(const Json& coordinates, Lines& lines) {
  std::vector<Vector2> line;
  if (!coordinates.is_array()) return;
  for (const Json& position : coordinates) {
    if (!position.is_array() || position.size() < 2 || !position[0].is_number() ||
        !position[1].is_number())
      return;
    line.emplace_back(position[0].get<double>(), position[1].get<double>());
  }
  if (line.size() >= 2) lines.push_back(std::move(line));
}

void read_geometry(const Json& geometry, Lines& lines, int depth = 0) {
  if (!geometry.is_object() || depth > 8) return;
  const std::string type = type_of(geometry);
  const Json coordinates = geometry.value("coordinates", Json::array());
  if (type == "LineString") read_line(coordinates, lines);
  if ((type == "MultiLineString" || type == "Polygon") && coordinates.is_array())
    for (const Json& line : coordinates) read_line(line, lines);
  if (type == "GeometryCollection" && geometry.contains("geometries"))
    for (const Json& one : geometry["geometries"]) read_geometry(one, lines, depth + 1);
}

// Steps between two places, each once and in neither direction.
std::set<std::pair<Place, Place>> steps_of(const Lines& lines) {
  std::set<std::pair<Place, Place>> steps;
  for (const auto& line : lines)
    for (std::size_t i = 1; i < line.size(); ++i) {
      const Place a{line[i - 1].x(), line[i - 1].y()}, b{line[i].x(), line[i].y()};
      if (a != b) steps.insert(std::minmax(a, b));
    }
  return steps;
}

// Chains of steps from one place where other than two of them meet to the next; then the rings.
Lines joined(const Lines& lines) {
  std::map<Place, std::vector<Place>> neighbours;
  std::set<std::pair<Place, Place>> left = steps_of(lines);
  for (const auto& [a, b] : left) {
    neighbours[a].push_back(b);
    neighbours[b].push_back(a);
  }
  Lines chains;
  const auto follow = [&](Place at, Place next) {
    std::vector<Vector2> chain{{at.first, at.second}};
    while (left.erase(std::minmax(at, next)) > 0) {
      chain.emplace_back(next.first, next.second);
      const auto& beyond = neighbours[next];
      if (beyond.size() != 2) break;
      at = std::exchange(next, beyond[0] == at ? beyond[1] : beyond[0]);
    }
    if (chain.size() >= 2) chains.push_back(std::move(chain));
  };
  for (const auto& [place, others] : neighbours)
    if (others.size() != 2)
      for (const Place& other : others) follow(place, other);
  while (!left.empty()) follow(left.begin()->first, left.begin()->second);
  return chains;
}

}  // namespace

Lines lines_of_geojson(std::string_view text) {
  const Json json = Json::parse(text, nullptr, false);
  if (!json.is_object()) return {};
  Lines lines;
  if (json.contains("features") && json["features"].is_array()) {
    for (const Json& feature : json["features"])
      if (feature.is_object()) read_geometry(feature.value("geometry", Json()), lines);
  } else {
    read_geometry(type_of(json) == "Feature" ? json.value("geometry", Json()) : json, lines);
  }
  return joined(lines);
}

}  // namespace stope::report
