#pragma once

#include <cstdint>
#include <string>
#include <unordered_map>
#include <vector>

#include "plugins/road_source/route_records.hpp"

namespace stope::road_source {

/// Finds the nodes of a route file by their ids there. Its constructor throws Error where two nodes
/// or two edges have the same id.
class RouteIndex {
 public:
  /// Both must outlive the index.
  RouteIndex(const RouteRecords& records, const std::string& file);

  /// The record of a node that is known to be there.
  std::size_t record_of(std::uint32_t id) const { return records_of_.at(id); }
  /// The record of a node that `origin` names as its `key`; throws Error if there is none.
  std::size_t need(std::uint32_t id, const char* key, Origin origin) const;
  /// The place in RoadGraph::nodes of a node where a road begins or ends; throws Error if there is
  /// none, or if it is the bend of another road.
  std::uint32_t place_of(std::uint32_t id, Origin origin) const;
  /// How many ids a node and an edge have in common.
  std::size_t shared_ids() const { return shared_ids_; }

  [[noreturn]] void fail(Origin origin, const std::string& what) const;

 private:
  const RouteRecords& records_;
  const std::string& file_;
  std::unordered_map<std::uint32_t, std::uint32_t> records_of_;
  std::vector<std::uint32_t> places_;  ///< by node record
  std::size_t shared_ids_ = 0;
};

}  // namespace stope::road_source
