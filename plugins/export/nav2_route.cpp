#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "plugins/export/route_writer.hpp"
#include "plugins/export/text_bytes.hpp"
#include "stope/stope.hpp"

namespace stope::exports {
namespace {

// nav2 keeps coordinates as 32-bit floats, whose steps exceed a centimetre from here on.
constexpr double kFarForFloats = 131072;

double farthest(const RoadGraph& roads) {
  double most = 0;
  for (const RoadNode& node : roads.nodes)
    most = std::max({most, std::abs(node.x), std::abs(node.y)});
  return most;
}

}  // namespace

class Nav2Route final : public Map<Artefact(RoadGraph)> {
 public:
  struct Params {
    std::string frame = "map";
    double tolerance = 0.05;
  } params;

  static void describe(About<Nav2Route>& about) {
    about.summary("Writes a road graph as the GeoJSON that nav2's route server loads.")
        .from("nav2_route, GeoJsonGraphFileLoader")
        .notes(
            "A road both ways becomes two edges each; a curved one a chain of nodes with "
            "metadata.stope {edge, seq}. Closed roads, and nodes that only they reach, have "
            "geometries nav2 passes over, so it does not drive them. A speed limit goes out as "
            "abs_speed_limit. road_source/nav2_route reads the same graph back, to the last bit.")
        .ports("roads", "artefact")
        .writes({"geojson"})
        .param("frame", &Params::frame, "The frame the coordinates are in.")
        .param(
            "tolerance", &Params::tolerance, "m", at_least(0.0),
            "How far nav2's chain of nodes may stray from a curve; 0 makes every vertex a node.");
  }

  Artefact apply(const RoadGraph& roads, Context& context) const {
    std::size_t open = 0;
    for (const RoadEdge& edge : roads.edges) open += edge.closed == 0 ? 1 : 0;
    if (open == 0) {
      throw Error(
          roads.edges.empty()
              ? "the road graph has no edges, and nav2 refuses such a graph: is any of the map "
                "free, and wide enough for a road between two places?"
              : "all edges of the road graph are closed, and nav2 refuses a graph without edges");
    }
    const std::string text = route_geojson(roads, {params.frame, params.tolerance});
    if (open < roads.edges.size())
      context.info(fmt::format("{} closed roads are in the file, but nav2 will not see them",
                               roads.edges.size() - open));
    if (farthest(roads) > kFarForFloats) {
      context.warn(
          fmt::format("the roads lie up to {:.0f} km from the origin, and nav2 keeps coordinates "
                      "as 32-bit floats, good to {:.0f} cm there: give the map a nearer origin",
                      farthest(roads) / 1000, farthest(roads) * 6e-6));
    }
    return {{{"geojson", bytes_of(text)}}};
  }
};

STOPE_STAGE(Nav2Route, "export/nav2_route")

}  // namespace stope::exports
