#include <fmt/format.h>

#include <cmath>
#include <string>

#include "plugins/export/text_bytes.hpp"
#include "stope/stope.hpp"

namespace stope::exports {
namespace {

constexpr const char* kHeader =
    "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
    "<graphml xmlns=\"http://graphml.graphdrawing.org/xmlns\">\n"
    "<key id=\"id\" for=\"all\" attr.name=\"id\" attr.type=\"long\"/>\n"
    "<key id=\"x\" for=\"node\" attr.name=\"x\" attr.type=\"double\"/>\n"
    "<key id=\"y\" for=\"node\" attr.name=\"y\" attr.type=\"double\"/>\n"
    "<key id=\"z\" for=\"node\" attr.name=\"z\" attr.type=\"double\"/>\n"
    "<key id=\"length\" for=\"edge\" attr.name=\"length\" attr.type=\"double\"/>\n"
    "<key id=\"min_clearance\" for=\"edge\" attr.name=\"min_clearance\" attr.type=\"double\"/>\n"
    "<key id=\"mean_clearance\" for=\"edge\" attr.name=\"mean_clearance\" attr.type=\"double\"/>\n"
    "<key id=\"width\" for=\"edge\" attr.name=\"width\" attr.type=\"double\"/>\n"
    "<key id=\"grade\" for=\"edge\" attr.name=\"grade\" attr.type=\"double\"/>\n"
    "<key id=\"curvature\" for=\"edge\" attr.name=\"curvature\" attr.type=\"double\"/>\n"
    "<key id=\"lane_width\" for=\"edge\" attr.name=\"lane_width\" attr.type=\"double\"/>\n"
    "<key id=\"speed_limit\" for=\"edge\" attr.name=\"speed_limit\" attr.type=\"double\"/>\n"
    "<key id=\"direction\" for=\"edge\" attr.name=\"direction\" attr.type=\"string\"/>\n"
    "<key id=\"closed\" for=\"edge\" attr.name=\"closed\" attr.type=\"boolean\"/>\n"
    "<key id=\"vertices\" for=\"edge\" attr.name=\"vertices\" attr.type=\"string\"/>\n"
    "<graph id=\"roads\" edgedefault=\"undirected\">\n";

/// XML Schema's lexical forms: GraphML numbers may be NaN.
std::string number(double value) {
  if (std::isnan(value)) return "NaN";
  if (std::isinf(value)) return value > 0 ? "INF" : "-INF";
  return fmt::format("{}", value);
}

template <class Value>
std::string data(const char* key, const Value& value) {
  return fmt::format("<data key=\"{}\">{}</data>", key, value);
}

const char* text_of(RoadDirection direction) {
  if (direction == RoadDirection::kForward) return "forward";
  return direction == RoadDirection::kBackward ? "backward" : "both";
}

}  // namespace

class Graphml final : public Map<Artefact(RoadGraph)> {
 public:
  struct Params {
  } params;

  static void describe(About<Graphml>& about) {
    about.summary("Writes a road graph as GraphML, with all its attributes.")
        .from("GraphML 1.0, graphml.graphdrawing.org")
        .notes(
            "Nothing is lost: numbers read back to the last bit. An edge's polyline stands in "
            "`vertices` as `x,y,z,clearance` separated by blanks; unknown numbers are NaN.")
        .ports("roads", "artefact")
        .writes({"graphml"});
  }

  Artefact apply(const RoadGraph& roads, Context&) const {
    std::string text = kHeader;
    for (std::size_t i = 0; i < roads.nodes.size(); ++i) {
      const RoadNode& node = roads.nodes[i];
      text += fmt::format("<node id=\"n{}\">", i) + data("id", node.id) +
              data("x", number(node.x)) + data("y", number(node.y)) + data("z", number(node.z)) +
              "</node>\n";
    }
    for (std::size_t i = 0; i < roads.edges.size(); ++i) {
      const RoadEdge& edge = roads.edges[i];
      text +=
          fmt::format("<edge id=\"e{}\" source=\"n{}\" target=\"n{}\">", i, edge.from, edge.to) +
          data("id", edge.id) + data("length", number(edge.length)) +
          data("min_clearance", number(edge.min_clearance)) +
          data("mean_clearance", number(edge.mean_clearance)) + data("width", number(edge.width)) +
          data("grade", number(edge.grade)) + data("curvature", number(edge.curvature)) +
          data("lane_width", number(edge.lane_width)) +
          data("speed_limit", number(edge.speed_limit)) +
          data("direction", text_of(edge.direction)) + data("closed", edge.closed != 0);
      std::string vertices;
      for (const RoadVertex& vertex : roads.polyline(edge)) {
        vertices += fmt::format("{}{},{},{},{}", vertices.empty() ? "" : " ", number(vertex.x),
                                number(vertex.y), number(vertex.z), number(vertex.clearance));
      }
      text += data("vertices", vertices) + "</edge>\n";
    }
    text += "</graph>\n</graphml>\n";
    return {{{"graphml", bytes_of(text)}}};
  }
};

STOPE_STAGE(Graphml, "export/graphml")

}  // namespace stope::exports
