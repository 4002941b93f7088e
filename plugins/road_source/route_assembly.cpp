#include "plugins/road_source/route_assembly.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <unordered_map>

#include "plugins/road_source/drawn_roads.hpp"
#include "plugins/road_source/route_index.hpp"
#include "stope/error.hpp"

namespace stope::road_source {
namespace {

bool same(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }

class Assembly {
 public:
  Assembly(const RouteRecords& records, const RouteDefaults& defaults, const std::string& file)
      : records_(records), index_(records, file), defaults_(defaults) {}

  AssembledRoads join() {
    add_nodes();
    add_chains();
    for (const RoadRecord& road : records_.closed) add_closed(road);
    add_drawn_roads(records_, index_, defaults_.clearance, result_);
    check_ids();
    canonicalize(result_.roads);
    restore_measures();
    warn_of_losses();
    return std::move(result_);
  }

 private:
  void add_nodes() {
    for (const NodeRecord& record : records_.nodes) {
      if (record.sequence == 0) result_.roads.nodes.push_back(record.node);
    }
  }

  // Parts of one road stand together, in the order of the chain, the forward one first.
  void add_chains() {
    std::vector<const LinkRecord*> parts;
    for (const LinkRecord& link : records_.links) {
      if (link.sequence > 0) parts.push_back(&link);
    }
    std::sort(parts.begin(), parts.end(), [](const LinkRecord* a, const LinkRecord* b) {
      return std::tie(a->road, a->sequence, a->back, a->origin.feature) <
             std::tie(b->road, b->sequence, b->back, b->origin.feature);
    });
    bends_.assign(records_.nodes.size(), false);
    for (std::size_t begin = 0; begin < parts.size();) {
      std::size_t end = begin;
      while (end < parts.size() && parts[end]->road == parts[begin]->road) ++end;
      add_chain({parts.begin() + static_cast<std::ptrdiff_t>(begin),
                 parts.begin() + static_cast<std::ptrdiff_t>(end)});
      begin = end;
    }
    for (std::size_t i = 0; i < bends_.size(); ++i) {
      if (records_.nodes[i].sequence > 0 && !bends_[i]) ++stray_bends_;
    }
  }

  void add_chain(const std::vector<const LinkRecord*>& parts) {
    const RoadRecord& road = road_of(parts);
    const LinkRecord& first = *parts.front();
    const bool forward = !first.back;
    const bool backward = first.back || (parts.size() > 1 && parts[1]->sequence == 1);
    const std::size_t a_step = (forward ? 1U : 0U) + (backward ? 1U : 0U);
    if (parts.size() != a_step * road.parts) {
      index_.fail(road.origin,
                  fmt::format("the road {} was written as {} parts {}, and {} are there: one is "
                              "missing or doubled. Bring it back, or delete all of the road",
                              first.road, a_step * road.parts,
                              a_step == 2 ? "(each in both directions)" : "", parts.size()));
    }
    RoadEdge edge = road.edge;
    edge.direction = !backward  ? RoadDirection::kForward
                     : !forward ? RoadDirection::kBackward
                                : RoadDirection::kBoth;
    std::vector<RoadVertex>& vertices = result_.roads.vertices;
    edge.first_vertex = static_cast<std::uint32_t>(vertices.size());
    std::uint32_t at = 0;
    for (std::uint32_t i = 0; i < road.parts; ++i) {
      const LinkRecord& part = *parts[i * a_step];
      check_part(part, i + 1, !forward, road);
      const auto [begin, end] = ends_of(part);
      if (a_step == 2) {
        const LinkRecord& other = *parts[i * 2 + 1];
        check_part(other, i + 1, true, road);
        if (ends_of(other) != ends_of(part))
          index_.fail(other.origin, fmt::format("it does not join the same nodes as edge {}, whose "
                                                "opposite it was",
                                                part.id));
      }
      if (i == 0) {
        edge.from = index_.place_of(begin, part.origin);
        vertices.push_back(end_vertex(begin, road.first, road.first_has_place));
      } else if (begin != at) {
        index_.fail(part.origin, fmt::format("part {} of the road {} does not begin where part {} "
                                             "ends",
                                             i + 1, first.road, i));
      }
      const LinkRecord& carrier = part;
      vertices.insert(vertices.end(), records_.vertices.begin() + carrier.first_vertex,
                      records_.vertices.begin() + carrier.first_vertex + carrier.vertex_count);
      if (i + 1 == road.parts) {
        edge.to = index_.place_of(end, part.origin);
        vertices.push_back(end_vertex(end, road.last, road.last_has_place));
      } else {
        vertices.push_back(bend(end, part, i + 1));
      }
      at = end;
    }
    edge.vertex_count = static_cast<std::uint32_t>(vertices.size()) - edge.first_vertex;
    result_.roads.edges.push_back(edge);
    measures_.emplace(edge.id, road.edge);
  }

  const RoadRecord& road_of(const std::vector<const LinkRecord*>& parts) const {
    const RoadRecord* road = nullptr;
    for (const LinkRecord* part : parts) {
      if (part->road_record == LinkRecord::kNone) continue;
      if (road)
        index_.fail(part->origin, fmt::format("a second feature is the first part of the "
                                              "road {}: the first is feature {}",
                                              part->road, road->origin.feature));
      road = &records_.roads[part->road_record];
    }
    if (!road) {
      index_.fail(parts.front()->origin,
                  fmt::format("the first part of the road {}, which says what the road is like, is "
                              "missing: bring it back, or delete all of the road",
                              parts.front()->road));
    }
    return *road;
  }

  void check_part(const LinkRecord& part, std::uint32_t sequence, bool back,
                  const RoadRecord& road) const {
    if (part.sequence != sequence || part.back != back) {
      index_.fail(part.origin, fmt::format("expected part {} of the road {} here{}, not part {}{}",
                                           sequence, part.road, back ? ", backwards" : "",
                                           part.sequence, part.back ? ", backwards" : ""));
    }
    if (!same(part.speed_limit, road.part_limit)) {
      index_.fail(part.origin, fmt::format("its abs_speed_limit is another than that of the road's "
                                           "first part (feature {}): change all parts of a road",
                                           road.origin.feature));
    }
  }

  // In the direction of the road's polyline.
  static std::pair<std::uint32_t, std::uint32_t> ends_of(const LinkRecord& part) {
    return part.back ? std::pair(part.end, part.start) : std::pair(part.start, part.end);
  }

  RoadVertex end_vertex(std::uint32_t id, const RoadVertex& written, bool has_place) const {
    if (has_place) return written;
    const RoadNode& node = records_.nodes[index_.record_of(id)].node;
    return {node.x, node.y, node.z, written.clearance};
  }

  RoadVertex bend(std::uint32_t id, const LinkRecord& part, std::uint32_t sequence) {
    const std::size_t record = index_.need(id, "endid", part.origin);
    const NodeRecord& node = records_.nodes[record];
    if (node.road != part.road || node.sequence != sequence) {
      index_.fail(part.origin,
                  fmt::format("node {} is not the bend {} of the road {} that was written here", id,
                              sequence, part.road));
    }
    bends_[record] = true;
    return {node.node.x, node.node.y, node.node.z, node.clearance};
  }

  void add_closed(const RoadRecord& road) {
    RoadEdge edge = road.edge;
    edge.from = index_.place_of(road.start, road.origin);
    edge.to = index_.place_of(road.end, road.origin);
    std::vector<RoadVertex>& vertices = result_.roads.vertices;
    edge.first_vertex = static_cast<std::uint32_t>(vertices.size());
    vertices.insert(vertices.end(), records_.vertices.begin() + road.edge.first_vertex,
                    records_.vertices.begin() + road.edge.first_vertex + road.edge.vertex_count);
    result_.roads.edges.push_back(edge);
    measures_.emplace(edge.id, road.edge);
  }

  void check_ids() const {
    const auto check = [&](const auto& items, const char* what) {
      std::vector<std::uint64_t> ids;
      for (const auto& item : items) {
        if (item.id != 0) ids.push_back(item.id);
      }
      std::sort(ids.begin(), ids.end());
      const auto twin = std::adjacent_find(ids.begin(), ids.end());
      if (twin != ids.end())
        index_.fail({}, fmt::format("two {} have the id {} in their metadata.stope", what, *twin));
    };
    check(result_.roads.nodes, "nodes");
    check(result_.roads.edges, "roads");
  }

  // Lengths and clearances were measured on the same line before, perhaps on a finer one: they hold
  // as long as nobody has moved it.
  void restore_measures() {
    std::size_t moved = 0;
    for (RoadEdge& edge : result_.roads.edges) {
      const auto written = measures_.find(edge.id);
      if (written == measures_.end()) continue;
      const RoadEdge& before = written->second;
      if (std::abs(before.length - edge.length) <= 1e-6 * (1 + edge.length)) {
        edge.length = before.length;
        edge.min_clearance = before.min_clearance;
        edge.mean_clearance = before.mean_clearance;
      } else {
        ++moved;
      }
    }
    if (moved > 0)
      warn("{} roads were moved since Stope wrote them: their lengths are measured again", moved);
  }

  void warn_of_losses() {
    const RoadGraph& roads = result_.roads;
    if (stray_bends_ > 0)
      warn("{} nodes are bends of roads that are no longer there, and are left out", stray_bends_);
    if (records_.written_roads && *records_.written_roads != roads.edges.size())
      warn("Stope wrote {} roads into this file, and {} are there now", *records_.written_roads,
           roads.edges.size());
    if (records_.written_nodes && *records_.written_nodes != roads.nodes.size())
      warn("Stope wrote {} nodes into this file, and {} are there now", *records_.written_nodes,
           roads.nodes.size());
    if (records_.passed_over > 0)
      warn("{} features are neither points nor lines, and are left out as nav2 leaves them out",
           records_.passed_over);
    std::string names;
    for (const auto& [name, count] : records_.lost)
      names += fmt::format("{}{} ({} times)", names.empty() ? "" : ", ", name, count);
    if (!names.empty()) warn("a road graph has no place for these, which are left out: {}", names);
    if (records_.frames.size() > 1) {
      index_.fail({},
                  fmt::format("its nodes lie in {} frames ({} and {}, for two): bring them into "
                              "one",
                              records_.frames.size(), *records_.frames.begin(),
                              *std::next(records_.frames.begin())));
    }
    if (index_.shared_ids() > 0)
      warn("{} ids belong to a node and to an edge: nav2 wants them unique over both",
           index_.shared_ids());
  }

  template <class... Values>
  void warn(fmt::format_string<Values...> format, Values&&... values) {
    result_.warnings.push_back(fmt::format(format, std::forward<Values>(values)...));
  }

  const RouteRecords& records_;
  RouteIndex index_;
  RouteDefaults defaults_;
  AssembledRoads result_;
  std::vector<bool> bends_;  ///< by node record: part of a road
  std::size_t stray_bends_ = 0;
  std::unordered_map<std::uint64_t, RoadEdge> measures_;  ///< as written, by the road's id
};

}  // namespace

AssembledRoads assemble(const RouteRecords& records, const RouteDefaults& defaults,
                        const std::string& file) {
  return Assembly(records, defaults, file).join();
}

}  // namespace stope::road_source
