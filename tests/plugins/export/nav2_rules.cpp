#include "tests/plugins/export/nav2_rules.hpp"

#include <cmath>
#include <limits>
#include <set>

namespace stope::exports {
namespace {

using nlohmann::json;

class Loader {
 public:
  Nav2Graph load(const json& file) {
    if (!file.is_object() || !file.contains("features") || !file["features"].is_array()) {
      complain("the file has no list of features");
      return std::move(graph_);
    }
    // Nodes first, whatever their order, as nav2 sorts features before it reads them.
    for (const json& feature : file["features"]) {
      if (type_of(feature) == "Point") node(feature);
    }
    for (const json& feature : file["features"]) {
      const std::string type = type_of(feature);
      if (type == "LineString" || type == "MultiLineString") edge(feature);
    }
    if (graph_.nodes.empty() || graph_.edges.empty()) complain("no nodes or no edges");
    return std::move(graph_);
  }

 private:
  // Each feature must have a geometry with a type: nav2 asks for both without looking.
  std::string type_of(const json& feature) {
    if (!feature.contains("geometry") || !feature["geometry"].is_object() ||
        !feature["geometry"].contains("type") || !feature["geometry"]["type"].is_string()) {
      complain("a feature has no geometry with a type");
      return "";
    }
    return feature["geometry"]["type"];
  }

  std::uint32_t id(const json& properties, const char* key) {
    if (!properties.contains(key) || !properties[key].is_number_unsigned() ||
        properties[key].get<std::uint64_t>() > std::numeric_limits<std::uint32_t>::max()) {
      complain(std::string(key) + " is no unsigned 32-bit number");
      return 0;
    }
    return properties[key].get<std::uint32_t>();
  }

  void unique(std::uint32_t id) {
    if (!ids_.insert(id).second) complain("the id " + std::to_string(id) + " is used twice");
  }

  void node(const json& feature) {
    const json& properties = feature["properties"];
    const std::uint32_t own = id(properties, "id");
    unique(own);
    const json& place = feature["geometry"]["coordinates"];
    if (!place.is_array() || place.size() < 2 || !place[0].is_number() || !place[1].is_number()) {
      complain("a node has no coordinates");
      return;
    }
    graph_.nodes[own] = {place[0].get<double>(), place[1].get<double>()};
    if (properties.contains("frame") && !properties["frame"].is_string())
      complain("'frame' is no text");
    if (properties.contains("metadata")) metadata(properties["metadata"]);
  }

  void edge(const json& feature) {
    const json& properties = feature["properties"];
    Nav2Graph::Edge edge{id(properties, "id"), id(properties, "startid"), id(properties, "endid"),
                         0, 0};
    unique(edge.id);
    for (const std::uint32_t end : {edge.start, edge.end}) {
      if (!graph_.nodes.contains(end)) complain("an edge ends at no node");
    }
    if (properties.contains("cost")) {
      if (!properties["cost"].is_number() || properties["cost"].get<double>() < 0)
        complain("'cost' is no number from 0");
      else
        edge.cost = properties["cost"].get<double>();
    }
    if (properties.contains("overridable") && !properties["overridable"].is_boolean())
      complain("'overridable' is neither true nor false");
    if (properties.contains("metadata")) {
      metadata(properties["metadata"]);
      // Scorers ask for exactly a float; what JSON shows as a whole number is none.
      for (const char* key : {"abs_speed_limit", "speed_limit", "penalty", "abs_time_taken"}) {
        if (properties["metadata"].contains(key) && !properties["metadata"][key].is_number_float())
          complain(std::string(key) + " is no float");
      }
      edge.abs_speed_limit = properties["metadata"].value("abs_speed_limit", 0.0);
    }
    graph_.edges.push_back(edge);
  }

  void metadata(const json& value) {
    if (!value.is_object()) return complain("'metadata' is no object");
    for (const auto& [key, item] : value.items()) {
      if (item.is_object()) {
        metadata(item);
      } else if (item.is_array()) {
        for (const json& element : item) primitive(key, element);
      } else {
        primitive(key, item);
      }
    }
  }

  void primitive(const std::string& key, const json& item) {
    if (!item.is_number() && !item.is_string() && !item.is_boolean())
      complain("metadata '" + key + "' is neither number, text nor truth");
  }

  void complain(std::string sentence) { graph_.complaints.push_back(std::move(sentence)); }

  Nav2Graph graph_;
  std::set<std::uint32_t> ids_;
};

}  // namespace

Nav2Graph load_as_nav2(const json& file) { return Loader().load(file); }

}  // namespace stope::exports
