#pragma once

#include <string>

#include "plugins/road_source/feature_scanner.hpp"
#include "plugins/road_source/route_records.hpp"

namespace stope::road_source {

/// Reads the features of a nav2 route graph one by one, as nav2's loader takes them: Points are
/// nodes, LineStrings and MultiLineStrings directed edges, all else it passes over; of that, what
/// Stope wrote (closed roads, nodes without open roads) is read too. Throws Error at the first
/// feature that is wrong.
class FeatureReader {
 public:
  /// `file` is what errors call it; it must outlive the reader.
  explicit FeatureReader(const std::string& file) : file_(file) {}

  void read(const FeatureText& text, std::uint32_t number);
  /// A member of the collection beside its features.
  void read_member(std::string_view name, const FeatureText& text);
  RouteRecords take() { return std::move(records_); }

 private:
  const std::string& file_;
  RouteRecords records_;
};

}  // namespace stope::road_source
