#pragma once

#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace stope::exports {

/// What nav2's route server makes of a route file, and what it (or a plugin of its that asks for a
/// value) would stumble over. Written from the rules of GeoJsonGraphFileLoader, apart from our own
/// exporter and reader.
struct Nav2Graph {
  struct Edge {
    std::uint32_t id, start, end;
    double cost;
    double abs_speed_limit;  ///< 0: none
  };
  std::map<std::uint32_t, std::pair<double, double>> nodes;
  std::vector<Edge> edges;
  std::vector<std::string> complaints;
};

Nav2Graph load_as_nav2(const nlohmann::json& file);

}  // namespace stope::exports
