#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "plugins/export/text_bytes.hpp"
#include "stope/stope.hpp"

namespace stope::exports {
namespace {

bool backwards(const PathPoint& a, const PathPoint& b) {
  const double yaw = a.yaw + std::remainder(b.yaw - a.yaw, 2 * std::numbers::pi) / 2;
  return (b.x - a.x) * std::cos(yaw) + (b.y - a.y) * std::sin(yaw) < 0;
}

bool stands(const PathPoint& point) { return point.speed == 0; }

/// Where the truck drives backwards before and forwards behind, or the other way round. A path
/// without speeds is a line and no drive: it has none.
std::vector<std::size_t> cusps_of(const std::vector<PathPoint>& points) {
  std::vector<std::size_t> cusps;
  if (std::all_of(points.begin(), points.end(), stands)) return cusps;
  for (std::size_t i = 1; i + 1 < points.size(); ++i)
    if (backwards(points[i - 1], points[i]) != backwards(points[i], points[i + 1]))
      cusps.push_back(i);
  return cusps;
}

/// Where the truck stops between its start and its end; of several points in a row the first.
std::vector<std::size_t> standstills_of(const std::vector<PathPoint>& points) {
  std::vector<std::size_t> standstills;
  const auto moves = std::find_if_not(points.begin(), points.end(), stands);
  for (auto stop = std::find_if(moves, points.end(), stands); stop != points.end();) {
    const auto on = std::find_if_not(stop, points.end(), stands);
    if (on == points.end()) break;  // its end
    standstills.push_back(static_cast<std::size_t>(stop - points.begin()));
    stop = std::find_if(on, points.end(), stands);
  }
  return standstills;
}

}  // namespace

class PathGeojson final : public Map<Artefact(Path)> {
 public:
  struct Params {
    std::string frame = "map";
  } params;

  static void describe(About<PathGeojson>& about) {
    about.summary("Writes a path as a GeoJSON line, in metres of the map's frame.")
        .notes(
            "Properties hold the length, the ids of the roads followed, and for every point its "
            "heading (yaw), clearance, curvature and speed (negative backwards, 0 where the truck "
            "stands, all 0 if none is planned); null where not known. standstills are the places "
            "in these lists, from 0, where the truck stops on its way, cusps those where the "
            "direction of driving changes.")
        .ports("path", "artefact")
        .writes({"geojson"})
        .param("frame", &Params::frame, "The frame the coordinates are in.");
  }

  Artefact apply(const Path& path, Context&) const {
    if (path.points.size() < 2)
      throw Error("the path has fewer than two points, which GeoJSON cannot hold as a line");
    const auto list = [&](auto&& item) {
      std::string text = "[";
      for (std::size_t i = 0; i < path.points.size(); ++i)
        text.append(i == 0 ? "" : ", ").append(item(path.points[i]));
      return text.append("]");
    };
    const std::string coordinates = list([](const PathPoint& point) {
      const std::string height = std::isfinite(point.z) ? ", " + json_number(point.z) : "";
      return fmt::format("[{}, {}{}]", json_number(point.x), json_number(point.y), height);
    });
    std::string edges;
    for (const std::uint64_t id : path.edges)
      edges.append(edges.empty() ? "" : ", ").append(std::to_string(id));
    const std::string text = fmt::format(
        "{{\n\"type\": \"FeatureCollection\",\n\"name\": \"path\",\n\"features\": [\n"
        "{{\"type\": \"Feature\", \"properties\": {{\n\"frame\": {},\n\"length\": {},\n\"edges\": "
        "[{}],\n\"yaw\": {},\n\"clearance\": {},\n\"curvature\": {},\n\"speed\": {},\n\"cusps\": "
        "[{}],\n\"standstills\": [{}]}},\n\"geometry\": "
        "{{\"type\": \"LineString\", \"coordinates\": {}}}}}\n]\n}}\n",
        json_text(params.frame), json_number(path.length), edges,
        list([](const PathPoint& point) { return json_number(point.yaw); }),
        list([](const PathPoint& point) { return json_number(point.clearance); }),
        list([](const PathPoint& point) { return json_number(point.curvature); }),
        list([](const PathPoint& point) { return json_number(point.speed); }),
        fmt::join(cusps_of(path.points), ", "), fmt::join(standstills_of(path.points), ", "),
        coordinates);
    return {{{"geojson", bytes_of(text)}}};
  }
};

STOPE_STAGE(PathGeojson, "export/path_geojson")

}  // namespace stope::exports
