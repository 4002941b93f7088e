#include "plugins/road_source/route_index.hpp"

#include <fmt/format.h>

#include "stope/error.hpp"

namespace stope::road_source {

RouteIndex::RouteIndex(const RouteRecords& records, const std::string& file)
    : records_(records), file_(file) {
  records_of_.reserve(records.nodes.size());
  std::uint32_t count = 0;
  for (std::size_t i = 0; i < records.nodes.size(); ++i) {
    const NodeRecord& node = records.nodes[i];
    places_.push_back(node.sequence == 0 ? count++ : LinkRecord::kNone);
    const auto [found, added] = records_of_.emplace(node.id, static_cast<std::uint32_t>(i));
    if (!added)
      fail(node.origin, fmt::format("node {} is there already, as feature {}: ids must be unique",
                                    node.id, records.nodes[found->second].origin.feature));
  }
  std::unordered_map<std::uint32_t, std::uint32_t> edges;
  edges.reserve(records.links.size());
  for (const LinkRecord& link : records.links) {
    const auto [found, added] = edges.emplace(link.id, link.origin.feature);
    if (!added)
      fail(link.origin, fmt::format("edge {} is there already, as feature {}: ids must be unique",
                                    link.id, found->second));
    shared_ids_ += records_of_.contains(link.id) ? 1 : 0;
    need(link.start, "startid", link.origin);
    need(link.end, "endid", link.origin);
  }
  for (const RoadRecord& road : records.closed) {
    need(road.start, "startid", road.origin);
    need(road.end, "endid", road.origin);
  }
}

std::size_t RouteIndex::need(std::uint32_t id, const char* key, Origin origin) const {
  const auto found = records_of_.find(id);
  if (found == records_of_.end())
    fail(origin, fmt::format("its {} is {}, and there is no node of that id", key, id));
  return found->second;
}

std::uint32_t RouteIndex::place_of(std::uint32_t id, Origin origin) const {
  const std::size_t record = need(id, "startid or endid", origin);
  if (places_[record] == LinkRecord::kNone) {
    const NodeRecord& node = records_.nodes[record];
    fail(origin,
         fmt::format("it begins or ends at node {}, which is a bend of the road {}: to join a road "
                     "there, delete 'stope' from the metadata of all of that road's features",
                     id, node.road));
  }
  return places_[record];
}

void RouteIndex::fail(Origin origin, const std::string& what) const {
  if (origin.feature == 0) throw Error(fmt::format("the road graph {}: {}", file_, what));
  throw Error(fmt::format("the road graph {}:{}: feature {}: {}", file_, origin.line,
                          origin.feature, what));
}

}  // namespace stope::road_source
