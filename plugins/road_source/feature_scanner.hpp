#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace stope::road_source {

/// A feature's text within its file, and where it begins.
struct FeatureText {
  std::string_view text;
  std::uint32_t line = 0;  ///< from 1
};

/// A GeoJSON FeatureCollection taken apart: its features and other members, not yet parsed.
struct Collection {
  std::vector<FeatureText> features;
  std::vector<std::pair<std::string_view, FeatureText>> members;  ///< names as written
};

/// Takes a FeatureCollection apart without parsing its features, so that a graph of a million nodes
/// need not stand in memory as a tree. `name` is what errors call it. Throws Error, naming the
/// line, where the text is cut off, is no JSON object or has no list of features.
Collection scan_features(std::string_view text, const std::string& name);

}  // namespace stope::road_source
