#include "plugins/road_source/feature_reader.hpp"

#include <fmt/format.h>

#include <cmath>

#include "plugins/road_source/feature_json.hpp"

namespace stope::road_source {
namespace {

using nlohmann::json;

/// Reads one feature into the records.
class OneFeature {
 public:
  OneFeature(FeatureJson& feature, RouteRecords& records) : feature_(feature), records_(records) {}

  void read() {
    const json& geometry = feature_.object(feature_.value(), "geometry");
    const auto type = geometry.find("type");
    if (type == geometry.end() || !type->is_string())
      feature_.fail("its geometry has no 'type' such as Point or LineString");
    const auto properties = feature_.value().find("properties");
    const bool named = properties != feature_.value().end() && properties->is_object();
    if (*type == "Point") {
      read_node(need_properties(), need(geometry, "coordinates"));
    } else if (*type == "LineString" || *type == "MultiLineString") {
      read_link(need_properties(), geometry);
    } else if (*type == "MultiPoint" && named && stope_of(*properties)) {
      const json& places = feature_.list(geometry, "coordinates");
      if (places.size() != 1) feature_.fail("a node must have one place");
      read_node(*properties, places[0]);
    } else if (*type == "GeometryCollection" && named && properties->contains("stope")) {
      read_closed(*properties, geometry);
    } else {
      ++records_.passed_over;
    }
  }

 private:
  const json& need_properties() const { return feature_.object(feature_.value(), "properties"); }
  const json& need(const json& in, const char* key) const {
    const auto found = in.find(key);
    if (found == in.end()) feature_.fail(fmt::format("'{}' is missing", key));
    return *found;
  }

  /// metadata.stope, or null.
  const json* stope_of(const json& properties) const {
    if (!properties.contains("metadata")) return nullptr;
    const json& metadata = feature_.object(properties, "metadata");
    return metadata.contains("stope") ? &feature_.object(metadata, "stope") : nullptr;
  }

  // What others wrote and a road graph cannot hold.
  void note_lost(const json& properties, std::initializer_list<const char*> kept) {
    if (properties.contains("operations")) ++records_.lost["operations"];
    if (!properties.contains("metadata")) return;
    for (const auto& [key, value] : feature_.object(properties, "metadata").items()) {
      bool known = false;
      for (const char* name : kept) known |= key == name;
      if (!known) ++records_.lost["metadata." + key];
    }
  }

  void read_node(const json& properties, const json& place) {
    NodeRecord record;
    record.origin = feature_.origin();
    record.id = feature_.nav2_id(properties, "id");
    feature_.call(fmt::format("node {}", record.id));
    const RoadVertex at = feature_.position(place);
    record.node = {record.id, at.x, at.y, at.z};
    if (properties.contains("frame")) {
      if (!properties["frame"].is_string()) feature_.fail("'frame' must be a text");
      records_.frames.insert(properties["frame"].get<std::string>());
    }
    if (const json* stope = stope_of(properties)) {
      if (stope->contains("edge")) {
        record.road = feature_.stope_id(*stope, "edge");
        record.sequence = feature_.count(*stope, "seq");
        record.clearance = feature_.number(*stope, "clearance");
      } else {
        record.node.id = feature_.stope_id(*stope, "node");
      }
    }
    note_lost(properties, {"stope"});
    records_.nodes.push_back(record);
  }

  void read_link(const json& properties, const json& geometry) {
    LinkRecord record;
    record.origin = feature_.origin();
    record.id = feature_.nav2_id(properties, "id");
    feature_.call(fmt::format("edge {}", record.id));
    record.start = feature_.nav2_id(properties, "startid");
    record.end = feature_.nav2_id(properties, "endid");
    if (properties.contains("cost")) feature_.real(properties["cost"], "'cost'");
    if (properties.contains("overridable") && !properties["overridable"].is_boolean())
      feature_.fail("'overridable' must be true or false");
    record.speed_limit = std::nan("");
    if (properties.contains("metadata")) {
      const json& metadata = feature_.object(properties, "metadata");
      record.speed_limit = feature_.number(metadata, "abs_speed_limit");
    }
    record.first_vertex = static_cast<std::uint32_t>(records_.vertices.size());
    if (const json* stope = stope_of(properties)) {
      read_part(*stope, record);
    } else {
      read_line(geometry);
      if (record.speed_limit <= 0) ++records_.lost["speed limits of 0 or less"];
      if (properties.contains("cost") && properties["cost"] != 0) ++records_.lost["cost"];
    }
    record.vertex_count =
        static_cast<std::uint32_t>(records_.vertices.size()) - record.first_vertex;
    note_lost(properties, {"stope", "abs_speed_limit"});
    records_.links.push_back(record);
  }

  void read_part(const json& stope, LinkRecord& record) {
    record.road = feature_.stope_id(stope, "edge");
    record.sequence = feature_.count(stope, "seq");
    record.back = stope.contains("back") && stope["back"] == true;
    if (stope.contains("between")) read_fours(feature_.list(stope, "between"));
    if (!stope.contains("parts")) return;
    RoadRecord road = read_attributes(stope);
    road.part_limit = record.speed_limit;
    road.edge.speed_limit =
        stope.contains("speed_limit") ? feature_.number(stope, "speed_limit") : record.speed_limit;
    road.parts = feature_.count(stope, "parts");
    road.first_has_place = read_end(stope, "first", road.first);
    road.last_has_place = read_end(stope, "last", road.last);
    record.road_record = static_cast<std::uint32_t>(records_.roads.size());
    records_.roads.push_back(road);
  }

  RoadRecord read_attributes(const json& stope) const {
    RoadRecord road;
    road.origin = feature_.origin();
    road.edge.id = feature_.stope_id(stope, "edge");
    road.edge.length = feature_.number(stope, "length");
    road.edge.min_clearance = feature_.number(stope, "min_clearance");
    road.edge.mean_clearance = feature_.number(stope, "mean_clearance");
    road.edge.width = feature_.number(stope, "width");
    road.edge.grade = feature_.number(stope, "grade");
    road.edge.curvature = feature_.number(stope, "curvature");
    road.edge.lane_width = feature_.number(stope, "lane_width");
    return road;
  }

  /// [clearance], or [x, y, z, clearance]. Whether the place was given.
  bool read_end(const json& stope, const char* key, RoadVertex& vertex) const {
    const json& numbers = feature_.list(stope, key);
    if (numbers.size() == 4) {
      vertex = four(numbers, 0);
      return true;
    }
    if (numbers.size() != 1) feature_.fail(fmt::format("'{}' must have one or four numbers", key));
    vertex.clearance = feature_.any_number(numbers[0], key);
    return false;
  }

  RoadVertex four(const json& numbers, std::size_t i) const {
    const char* what = "a number of the road's line";
    return {feature_.real(numbers[i], what), feature_.real(numbers[i + 1], what),
            feature_.any_number(numbers[i + 2], what), feature_.any_number(numbers[i + 3], what)};
  }

  void read_fours(const json& numbers) {
    if (numbers.size() % 4 != 0) feature_.fail("'between' must have four numbers a vertex");
    for (std::size_t i = 0; i < numbers.size(); i += 4)
      records_.vertices.push_back(four(numbers, i));
  }

  // nav2 never looks at an edge's line, so it may be missing; some write no coordinates at all.
  void read_line(const json& geometry) {
    const auto coordinates = geometry.find("coordinates");
    if (coordinates == geometry.end() || coordinates->is_null()) return;
    if (!coordinates->is_array()) feature_.fail("its 'coordinates' are no list");
    for (const json& item : *coordinates) {
      if (geometry["type"] == "LineString") {
        records_.vertices.push_back(feature_.position(item));
      } else {
        if (!item.is_array()) feature_.fail("a line of its MultiLineString is no list");
        for (const json& place : item) records_.vertices.push_back(feature_.position(place));
      }
    }
  }

  void read_closed(const json& properties, const json& geometry) {
    const json& stope = feature_.object(properties, "stope");
    RoadRecord road = read_attributes(stope);
    feature_.call(fmt::format("closed road {}", road.edge.id));
    road.edge.closed = feature_.count(stope, "closed");
    road.edge.speed_limit = feature_.number(stope, "speed_limit");
    const std::string direction =
        stope.contains("direction") && stope["direction"].is_string() ? stope["direction"] : "";
    if (direction != "both" && direction != "forward" && direction != "backward")
      feature_.fail("'direction' must be both, forward or backward");
    road.edge.direction = direction == "forward"    ? RoadDirection::kForward
                          : direction == "backward" ? RoadDirection::kBackward
                                                    : RoadDirection::kBoth;
    road.start = feature_.nav2_id(properties, "startid");
    road.end = feature_.nav2_id(properties, "endid");
    const json& lines = feature_.list(geometry, "geometries");
    if (lines.size() != 1 || !lines[0].is_object())
      feature_.fail("its geometry must hold one LineString");
    const json& places = feature_.list(lines[0], "coordinates");
    const json& clearance = feature_.list(stope, "clearance");
    if (places.size() < 2 || clearance.size() != places.size())
      feature_.fail(fmt::format("it has {} places and {} clearances: expected as many, two or more",
                                places.size(), clearance.size()));
    road.edge.first_vertex = static_cast<std::uint32_t>(records_.vertices.size());
    road.edge.vertex_count = static_cast<std::uint32_t>(places.size());
    for (std::size_t i = 0; i < places.size(); ++i) {
      records_.vertices.push_back(feature_.position(places[i]));
      records_.vertices.back().clearance = feature_.any_number(clearance[i], "a clearance");
    }
    records_.closed.push_back(road);
  }

  FeatureJson& feature_;
  RouteRecords& records_;
};

}  // namespace

void FeatureReader::read(const FeatureText& text, std::uint32_t number) {
  FeatureJson feature(file_, text, number);
  OneFeature(feature, records_).read();
}

void FeatureReader::read_member(std::string_view name, const FeatureText& text) {
  if (name != "stope") return;
  const FeatureJson member(file_, text, 0);
  if (const auto version = member.value().find("version");
      version == member.value().end() || *version != 1) {
    member.fail(
        fmt::format("the route graph's 'stope' has the version {}: this Stope reads 1 only",
                    version == member.value().end() ? "none" : version->dump().substr(0, 40)));
  }
  records_.written_nodes = member.stope_id(member.value(), "nodes");
  records_.written_roads = member.stope_id(member.value(), "roads");
}

}  // namespace stope::road_source
