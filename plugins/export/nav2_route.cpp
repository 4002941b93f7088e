#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "plugins/export/simplify.hpp"
#include "plugins/export/text_bytes.hpp"
#include "stope/stope.hpp"

namespace stope::exports {
namespace {

/// nav2's loader reads nothing of an edge but the nodes it joins, so a curved road goes out as a
/// chain of nodes. Nodes are numbered 0 … n-1, edges from n on.
class RouteWriter {
 public:
  RouteWriter(const RoadGraph& graph, std::string frame, double tolerance)
      : graph_(graph), frame_(std::move(frame)), tolerance_(tolerance) {}

  std::string write() {
    for (const RoadNode& node : graph_.nodes) {
      add_node(node.x, node.y, node.z, fmt::format("\"node\": {}", node.id));
    }
    for (const RoadEdge& edge : graph_.edges) {
      if (edge.closed == 0) add_chain(edge);
    }
    const std::uint64_t features = node_count_ + links_.size();
    if (features > std::numeric_limits<std::uint32_t>::max())
      throw Error("the road graph has more parts than nav2 has ids: raise 'tolerance'");
    std::uint64_t id = node_count_;
    for (const Link& link : links_) add_link(id++, link);
    text_ += "\n]\n}\n";
    return std::move(text_);
  }

 private:
  struct Link {
    std::uint64_t from, to;
    double from_x, from_y, to_x, to_y;
    double length;
    const RoadEdge* edge;
    std::size_t sequence;
  };

  void begin_feature() {
    text_ += text_.empty() ? "{\n\"type\": \"FeatureCollection\",\n\"name\": \"graph\",\n"
                             "\"features\": [\n"
                           : ",\n";
  }

  std::uint64_t add_node(double x, double y, double z, const std::string& stope) {
    begin_feature();
    const std::string height =
        std::isfinite(z) ? fmt::format(", \"z\": {}", json_number(z)) : std::string();
    text_ += fmt::format(
        "{{\"type\": \"Feature\", \"properties\": {{\"id\": {}, \"frame\": {}, \"metadata\": "
        "{{\"stope\": {{{}{}}}}}}}, \"geometry\": {{\"type\": \"Point\", \"coordinates\": [{}, "
        "{}]}}}}",
        node_count_, json_text(frame_), stope, height, json_number(x), json_number(y));
    return node_count_++;
  }

  void add_chain(const RoadEdge& edge) {
    const auto line = graph_.polyline(edge);
    const auto kept = simplify(line, tolerance_);
    std::uint64_t previous = edge.from;
    for (std::size_t i = 1; i < kept.size(); ++i) {
      const RoadVertex &a = line[kept[i - 1]], &b = line[kept[i]];
      const std::uint64_t next =
          i + 1 == kept.size()
              ? edge.to
              : add_node(b.x, b.y, b.z, fmt::format("\"edge\": {}, \"seq\": {}", edge.id, i));
      double length = 0;
      for (std::size_t v = kept[i - 1] + 1; v <= kept[i]; ++v)
        length += std::hypot(line[v].x - line[v - 1].x, line[v].y - line[v - 1].y);
      if (edge.direction != RoadDirection::kBackward)
        links_.push_back({previous, next, a.x, a.y, b.x, b.y, length, &edge, i});
      if (edge.direction != RoadDirection::kForward)
        links_.push_back({next, previous, b.x, b.y, a.x, a.y, length, &edge, i});
      previous = next;
    }
  }

  void add_link(std::uint64_t id, const Link& link) {
    begin_feature();
    std::string metadata =
        fmt::format("\"stope\": {{\"edge\": {}, \"seq\": {}", link.edge->id, link.sequence);
    const auto add = [&](const char* name, double value) {
      if (std::isfinite(value)) metadata += fmt::format(", \"{}\": {}", name, value);
    };
    add("min_clearance", link.edge->min_clearance);
    add("width", link.edge->width);
    add("lane_width", link.edge->lane_width);
    metadata += "}";
    add("abs_speed_limit", link.edge->speed_limit);
    text_ += fmt::format(
        "{{\"type\": \"Feature\", \"properties\": {{\"id\": {}, \"startid\": {}, \"endid\": {}, "
        "\"cost\": {}, \"overridable\": true, \"metadata\": {{{}}}}}, \"geometry\": {{\"type\": "
        "\"LineString\", \"coordinates\": [[{}, {}], [{}, {}]]}}}}",
        id, link.from, link.to, json_number(link.length), metadata, json_number(link.from_x),
        json_number(link.from_y), json_number(link.to_x), json_number(link.to_y));
  }

  const RoadGraph& graph_;
  std::string frame_;
  double tolerance_;
  std::string text_;
  std::uint64_t node_count_ = 0;
  std::vector<Link> links_;
};

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
            "metadata.stope {edge, seq}. Closed roads are left out, since nav2 would drive them. "
            "A speed limit goes out as abs_speed_limit.")
        .ports("roads", "artefact")
        .writes({"geojson"})
        .param("frame", &Params::frame, "The frame the coordinates are in.")
        .param("tolerance", &Params::tolerance, "m", at_least(0.0),
               "How far a curve may be straightened; 0 keeps every vertex.");
  }

  Artefact apply(const RoadGraph& roads, Context& context) const {
    std::size_t open = 0;
    for (const RoadEdge& edge : roads.edges) open += edge.closed == 0 ? 1 : 0;
    if (open == 0) {
      throw Error(
          roads.edges.empty()
              ? "the road graph has no edges, and nav2 refuses such a graph: is any of the map "
                "free?"
              : "all edges of the road graph are closed, and nav2 refuses a graph without edges");
    }
    if (open < roads.edges.size())
      context.warn(fmt::format("{} closed roads are left out", roads.edges.size() - open));
    return {{{"geojson", bytes_of(RouteWriter(roads, params.frame, params.tolerance).write())}}};
  }
};

STOPE_STAGE(Nav2Route, "export/nav2_route")

}  // namespace stope::exports
