#pragma once

#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "stope/payloads/road_graph.hpp"

namespace stope::road_source {

/// Where in the file something stands: its feature, counted from 1, and the line it begins on.
struct Origin {
  std::uint32_t feature = 0, line = 0;
};

/// A node of nav2's graph: a place where roads meet, or (sequence > 0) a bend of one that Stope
/// wrote.
struct NodeRecord {
  Origin origin;
  std::uint32_t id = 0;  ///< the file's
  RoadNode node;         ///< with the id that Stope wrote, or else the file's
  std::uint64_t road = 0;
  std::uint32_t sequence = 0;
  double clearance = 0;
};

/// A directed edge of nav2's graph: a road of its own, or (sequence > 0) part of one that Stope
/// wrote.
struct LinkRecord {
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
  Origin origin;
  std::uint32_t id = 0, start = 0, end = 0;  ///< the file's
  std::uint64_t road = 0;
  std::uint32_t sequence = 0;
  bool back = false;                  ///< against the road's polyline
  double speed_limit = 0;             ///< m/s; NaN: none
  std::uint32_t road_record = kNone;  ///< in RouteRecords::roads, if this part carries it
  std::uint32_t first_vertex = 0, vertex_count = 0;  ///< the line as drawn, or a part's vertices
                                                     ///< between its ends
};

/// What Stope wrote of a road.
struct RoadRecord {
  Origin origin;
  RoadEdge edge;  ///< of a closed one with its run of vertices
  std::uint32_t parts = 0;
  double part_limit = 0;   ///< the speed limit that each part must have, m/s; NaN: none
  RoadVertex first, last;  ///< the clearance is given always,
  bool first_has_place = false, last_has_place = false;  ///< the place where the node's is another
  std::uint32_t start = 0, end = 0;                      ///< of a closed one: the file's ids
};

/// All that a route file says, before it is joined.
struct RouteRecords {
  std::vector<NodeRecord> nodes;
  std::vector<LinkRecord> links;
  std::vector<RoadRecord> roads, closed;
  std::vector<RoadVertex> vertices;
  std::size_t passed_over = 0;              ///< features that nav2 does not look at
  std::map<std::string, std::size_t> lost;  ///< what has no place in a road graph, by name
  std::set<std::string> frames;
  std::optional<std::uint64_t> written_nodes, written_roads;  ///< as Stope counted on writing
};

}  // namespace stope::road_source
