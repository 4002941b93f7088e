#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "stope/label_cells.hpp"
#include "stope/payloads/grid_frame.hpp"

namespace stope {

/// A region of free space.
struct Region {
  std::uint64_t id = 0;
  double x = 0, y = 0;                   ///< centre, metres, map frame
  double major = 0, minor = 0, yaw = 0;  ///< semi-axes in metres and the major one's heading
  double area = 0;                       ///< m^2
  static constexpr void fields(auto& s, auto&& visit) {
    visit("id", s.id);
    visit("x", s.x);
    visit("y", s.y);
    visit("major", s.major);
    visit("minor", s.minor);
    visit("yaw", s.yaw);
    visit("area", s.area);
  }
};

/// What a LabelGrid has, of which maps that follow each other share what is the same.
struct RegionLabels {
  GridFrame frame;
  LabelCells cells;                      ///< row-major, row 0 lowest; 0 is none
  std::vector<std::string> names;        ///< of the labels, by value
  std::optional<ChangedWindow> changed;  ///< none: all of it may differ from earlier items
  static constexpr void fields(auto& s, auto&& visit) {
    visit("frame", s.frame);
    visit("cells", s.cells);
    visit("names", s.names);
    visit("changed", s.changed);
  }
};

/// Free space divided into regions. `labels` holds a region's place plus one in each of its cells.
struct RegionMap {
  static constexpr std::string_view kType = "stope/RegionMap@1";
  std::vector<Region> regions;           ///< ids strictly increasing
  std::vector<std::uint32_t> adjacency;  ///< pairs of places, lower first, in increasing order
  std::vector<std::string> semantics;    ///< by region, or empty
  RegionLabels labels;
  static constexpr void fields(auto& s, auto&& visit) {
    visit("regions", s.regions);
    visit("adjacency", s.adjacency);
    visit("semantics", s.semantics);
    visit("labels", s.labels);
  }
};

}  // namespace stope
