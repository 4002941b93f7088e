#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <string_view>
#include <vector>

#include "stope/geometry.hpp"
#include "stope/visibility.hpp"

namespace stope {

/// A place where roads meet or end.
struct RoadNode {
  std::uint64_t id = 0;        ///< stable: the same place keeps it when the graph is recomputed
  double x = 0, y = 0, z = 0;  ///< metres, map frame; z is NaN where there is no elevation
  static constexpr void fields(auto& s, auto&& visit) {
    visit("id", s.id);
    visit("x", s.x);
    visit("y", s.y);
    visit("z", s.z);
  }
};

/// Which way a road may be driven, seen along its polyline.
enum class RoadDirection : std::uint32_t { kBoth = 0, kForward = 1, kBackward = 2 };

/// A road between two nodes: a polyline from the first node's place to the second's, both included.
struct RoadEdge {
  std::uint64_t id = 0;                                     ///< stable, as a node's
  std::uint32_t from = 0, to = 0;                           ///< places in RoadGraph::nodes
  std::uint32_t first_vertex = 0, vertex_count = 0;         ///< run in RoadGraph::vertices, >= 2
  double length = 0;                                        ///< metres along the polyline
  double min_clearance = 0, mean_clearance = 0;             ///< metres to the nearest obstacle
  double width = 0;                                         ///< metres, of the drivable strip
  double grade = std::numeric_limits<double>::quiet_NaN();  ///< steepest, rise over run, >= 0; NaN:
                                                            ///< no elevation
  double curvature = 0;                                     ///< tightest, 1/m, >= 0
  double lane_width = std::numeric_limits<double>::quiet_NaN();   ///< metres; NaN: not known
  double speed_limit = std::numeric_limits<double>::quiet_NaN();  ///< m/s; NaN: none
  RoadDirection direction = RoadDirection::kBoth;
  std::uint32_t closed = 0;  ///< 1: not to be driven
  static constexpr void fields(auto& s, auto&& visit) {
    visit("id", s.id);
    visit("from", s.from);
    visit("to", s.to);
    visit("first_vertex", s.first_vertex);
    visit("vertex_count", s.vertex_count);
    visit("length", s.length);
    visit("min_clearance", s.min_clearance);
    visit("mean_clearance", s.mean_clearance);
    visit("width", s.width);
    visit("grade", s.grade);
    visit("curvature", s.curvature);
    visit("lane_width", s.lane_width);
    visit("speed_limit", s.speed_limit);
    visit("direction", s.direction);
    visit("closed", s.closed);
  }
};

/// A vertex of a road's centre line.
struct RoadVertex {
  double x = 0, y = 0, z = 0;  ///< metres, map frame; z is NaN where there is no elevation
  double clearance = 0;        ///< metres to the nearest obstacle
  static constexpr void fields(auto& s, auto&& visit) {
    visit("x", s.x);
    visit("y", s.y);
    visit("z", s.z);
    visit("clearance", s.clearance);
  }
};

/// The network of roads. In canonical order: nodes by (x, y, id), edges by their first and second
/// node and then their vertices, an edge's polyline from its lower node to its higher; so equal
/// networks have equal digests.
struct RoadGraph {
  static constexpr std::string_view kType = "stope/RoadGraph@2";
  std::vector<RoadNode> nodes;
  std::vector<RoadEdge> edges;
  std::vector<RoadVertex> vertices;
  std::span<const RoadVertex> polyline(const RoadEdge& edge) const {
    return std::span(vertices).subspan(edge.first_vertex, edge.vertex_count);
  }
  static constexpr void fields(auto& s, auto&& visit) {
    visit("nodes", s.nodes);
    visit("edges", s.edges);
    visit("vertices", s.vertices);
  }
};

/// Metres along an edge over which its grade and its curvature are measured; of a shorter edge the
/// whole length.
inline constexpr double kRoadGradeLength = 10.0, kRoadCurvatureLength = 10.0;

/// Brings a graph into canonical order and fills each edge's length, clearances, grade and curvature
/// from its vertices. The grade is that of the steepest stretch of kRoadGradeLength whose ends'
/// heights are known, and stays as it is if no vertex has one; the curvature is the largest of a
/// circle through both ends and the middle of a stretch of kRoadCurvatureLength. Nodes and edges whose id is 0 get one made of their geometry (to the centimetre),
/// which stays the same while they do not move.
STOPE_API void canonicalize(RoadGraph& graph);

}  // namespace stope
