// nav2's loader keeps of a node its place and metadata, of an edge the ids of its ends, cost and
// metadata; it never looks at an edge's line, and passes over every feature whose geometry is
// neither Point, LineString nor MultiLineString. So an open road goes out as a chain of nodes and
// links, as straight as the tolerance allows, and what only Stope wants of it rides along in
// metadata.stope; a closed road goes out as a GeometryCollection and a node without open roads as a
// MultiPoint, which every viewer draws and nav2 does not see. Cost: linear.
#include "plugins/export/route_writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <vector>

#include "plugins/export/route_rules.hpp"
#include "plugins/export/simplify.hpp"
#include "plugins/export/text_bytes.hpp"
#include "stope/error.hpp"

namespace stope::exports {
namespace {

class RouteWriter {
 public:
  RouteWriter(const RoadGraph& graph, const RouteStyle& style)
      : graph_(graph), frame_(json_text(style.frame)), tolerance_(style.tolerance) {}

  std::string write() {
    print(
        "{{\n\"type\": \"FeatureCollection\",\n\"name\": \"graph\",\n\"stope\": {{\"version\": 1, "
        "\"nodes\": {}, \"roads\": {}}},\n\"features\": [",
        graph_.nodes.size(), graph_.edges.size());
    std::vector<bool> open(graph_.nodes.size());
    for (const RoadEdge& edge : graph_.edges) {
      if (edge.closed == 0) open[edge.from] = open[edge.to] = true;
    }
    for (std::size_t i = 0; i < graph_.nodes.size(); ++i) {
      const RoadNode& node = graph_.nodes[i];
      begin_node(fmt::format("\"node\": {}", json_id(node.id)));
      const std::string place = position(node.x, node.y, node.z);
      if (open[i]) {
        print("{{\"type\": \"Point\", \"coordinates\": {}}}}}", place);
      } else {
        print("{{\"type\": \"MultiPoint\", \"coordinates\": [{}]}}}}", place);
      }
    }
    for (const RoadEdge& edge : graph_.edges) {
      if (edge.closed == 0) add_chain(edge);
    }
    std::uint64_t id = node_count_;
    if (id + links_.size() > std::numeric_limits<std::uint32_t>::max())
      throw Error("the road graph has more parts than nav2 has ids: raise 'tolerance'");
    for (const Link& link : links_) add_link(id++, link);
    for (const RoadEdge& edge : graph_.edges) {
      if (edge.closed != 0) add_closed(edge);
    }
    print("\n]\n}}\n");
    return std::move(text_);
  }

 private:
  struct Link {
    std::uint64_t from, to;
    RoadVertex from_vertex, to_vertex;
    double length;
    const RoadEdge* edge;
    std::size_t sequence;
    std::string stope;  ///< what Stope keeps beside the road's id and the place in its chain
  };

  template <class... Values>
  void print(fmt::format_string<Values...> format, Values&&... values) {
    fmt::format_to(std::back_inserter(text_), format, std::forward<Values>(values)...);
  }
  static std::string position(double x, double y, double z) {
    const std::string height = std::isnan(z) ? std::string() : fmt::format(", {}", json_real(z));
    return fmt::format("[{}, {}{}]", json_real(x), json_real(y), height);
  }

  void begin_feature() {
    text_ += first_ ? "\n" : ",\n";
    first_ = false;
  }

  void begin_node(const std::string& stope) {
    begin_feature();
    print(
        "{{\"type\": \"Feature\", \"properties\": {{\"id\": {}, \"frame\": {}, \"metadata\": "
        "{{\"stope\": {{{}}}}}}}, \"geometry\": ",
        node_count_++, frame_, stope);
  }

  std::uint64_t add_bend(const RoadEdge& edge, std::size_t sequence, const RoadVertex& vertex) {
    begin_node(fmt::format("\"edge\": {}, \"seq\": {}{}", json_id(edge.id), sequence,
                           member("clearance", vertex.clearance)));
    print("{{\"type\": \"Point\", \"coordinates\": {}}}}}", position(vertex.x, vertex.y, vertex.z));
    return node_count_ - 1;
  }

  void add_chain(const RoadEdge& edge) {
    const auto line = graph_.polyline(edge);
    const auto kept = simplify(line, tolerance_);
    std::uint64_t previous = edge.from;
    for (std::size_t i = 1; i < kept.size(); ++i) {
      const RoadVertex &a = line[kept[i - 1]], &b = line[kept[i]];
      const std::uint64_t next = i + 1 == kept.size() ? edge.to : add_bend(edge, i, b);
      std::string stope;
      if (i == 1) {
        stope = attributes(edge) + ends(edge, line) + parts(kept.size() - 1);
        // An infinite limit is none that nav2 could read.
        if (std::isinf(edge.speed_limit)) stope += member("speed_limit", edge.speed_limit);
      }
      double length = 0;
      std::string between;
      for (std::size_t v = kept[i - 1] + 1; v <= kept[i]; ++v) {
        length += std::hypot(line[v].x - line[v - 1].x, line[v].y - line[v - 1].y);
        if (v < kept[i]) between.append(between.empty() ? "" : ", ").append(four_numbers(line[v]));
      }
      if (!between.empty()) stope += fmt::format(", \"between\": [{}]", between);
      const bool both = edge.direction == RoadDirection::kBoth;
      if (edge.direction != RoadDirection::kBackward)
        links_.push_back({previous, next, a, b, length, &edge, i, stope});
      if (edge.direction != RoadDirection::kForward)
        links_.push_back({next, previous, b, a, length, &edge, i,
                          fmt::format(", \"back\": true{}", both ? "" : stope)});
      previous = next;
    }
  }

  void add_link(std::uint64_t id, const Link& link) {
    begin_feature();
    std::string metadata = fmt::format("\"stope\": {{\"edge\": {}, \"seq\": {}{}}}",
                                       json_id(link.edge->id), link.sequence, link.stope);
    // nav2 asks for a float: one that JSON shows as a whole number would be another type there.
    if (std::isfinite(link.edge->speed_limit))
      metadata += fmt::format(", \"abs_speed_limit\": {}", json_real(link.edge->speed_limit));
    print(
        "{{\"type\": \"Feature\", \"properties\": {{\"id\": {}, \"startid\": {}, \"endid\": {}, "
        "\"cost\": {}, \"overridable\": true, \"metadata\": {{{}}}}}, \"geometry\": {{\"type\": "
        "\"LineString\", \"coordinates\": [[{}, {}], [{}, {}]]}}}}",
        id, link.from, link.to, json_real(link.length), metadata, json_real(link.from_vertex.x),
        json_real(link.from_vertex.y), json_real(link.to_vertex.x), json_real(link.to_vertex.y));
  }

  void add_closed(const RoadEdge& edge) {
    begin_feature();
    std::string line, clearance;
    for (const RoadVertex& vertex : graph_.polyline(edge)) {
      const char* comma = line.empty() ? "" : ", ";
      line.append(comma).append(position(vertex.x, vertex.y, vertex.z));
      clearance.append(comma).append(json_any(vertex.clearance));
    }
    const char* direction = edge.direction == RoadDirection::kForward    ? "forward"
                            : edge.direction == RoadDirection::kBackward ? "backward"
                                                                         : "both";
    print(
        "{{\"type\": \"Feature\", \"properties\": {{\"startid\": {}, \"endid\": {}, \"stope\": "
        "{{\"edge\": {}, \"closed\": {}, \"direction\": \"{}\"{}{}, \"clearance\": [{}]}}}}, "
        "\"geometry\": {{\"type\": \"GeometryCollection\", \"geometries\": [{{\"type\": "
        "\"LineString\", \"coordinates\": [{}]}}]}}}}",
        edge.from, edge.to, json_id(edge.id), edge.closed, direction, attributes(edge),
        member("speed_limit", edge.speed_limit), clearance, line);
  }

  /// `, "name": value`; nothing for NaN, which stands for not known.
  static std::string member(const char* name, double value) {
    return std::isnan(value) ? std::string() : fmt::format(", \"{}\": {}", name, json_any(value));
  }

  static std::string attributes(const RoadEdge& edge) {
    return member("length", edge.length) + member("min_clearance", edge.min_clearance) +
           member("mean_clearance", edge.mean_clearance) + member("width", edge.width) +
           member("grade", edge.grade) + member("curvature", edge.curvature) +
           member("lane_width", edge.lane_width);
  }

  static std::string parts(std::size_t count) { return fmt::format(", \"parts\": {}", count); }

  static std::string four_numbers(const RoadVertex& vertex) {
    return fmt::format("{}, {}, {}, {}", json_any(vertex.x), json_any(vertex.y), json_any(vertex.z),
                       json_any(vertex.clearance));
  }

  /// The clearance at both ends; the place too where it is not exactly the node's.
  std::string ends(const RoadEdge& edge, std::span<const RoadVertex> line) const {
    const auto end = [&](const char* name, const RoadVertex& vertex, const RoadNode& node) {
      const bool at_node = vertex.x == node.x && vertex.y == node.y &&
                           (vertex.z == node.z || (std::isnan(vertex.z) && std::isnan(node.z)));
      return fmt::format(", \"{}\": [{}]", name,
                         at_node ? json_any(vertex.clearance) : four_numbers(vertex));
    };
    return end("first", line.front(), graph_.nodes[edge.from]) +
           end("last", line.back(), graph_.nodes[edge.to]);
  }

  const RoadGraph& graph_;
  std::string frame_;
  double tolerance_;
  std::string text_;
  bool first_ = true;
  std::uint64_t node_count_ = 0;
  std::vector<Link> links_;
};

}  // namespace

std::string route_geojson(const RoadGraph& graph, const RouteStyle& style) {
  check_writable(graph);
  return RouteWriter(graph, style).write();
}

}  // namespace stope::exports
