#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "framework/report/picture.hpp"
#include "stope/geometry.hpp"
#include "stope/payloads/grid_frame.hpp"
#include "stope/payloads/measures.hpp"
#include "stope/time.hpp"

namespace stope::report {

/// A polyline in the map frame, metres.
struct Stroke {
  std::string style;  ///< a class of the report's style sheet: `road`, `path`, `track`…
  std::vector<Vector2> points;
  bool closed = false;
  std::string title;  ///< shown under the pointer
  static constexpr void fields(auto& s, auto&& visit) {
    visit("style", s.style);
    visit("points", s.points);
    visit("closed", s.closed);
    visit("title", s.title);
  }
};

/// A point in the map frame, metres.
struct Mark {
  std::string style;  ///< as Stroke::style: `junction`, `dead-end`, `start`, `goal`…
  Vector2 place = Vector2::Zero();
  std::string title;
  static constexpr void fields(auto& s, auto&& visit) {
    visit("style", s.style);
    visit("place", s.place);
    visit("title", s.title);
  }
};

/// A picture of a grid. It covers exactly the grid's area, whatever its number of pixels.
struct Raster {
  GridFrame frame;  ///< of the grid that was drawn
  Picture picture;
  bool neutral = false;  ///< greys, which a dark page may invert
  /// The picture as a file, once it is packed; it has no pixels any more then. To be kept, and read
  /// again by each run that changes nothing, pixels would be twenty times as much.
  std::vector<std::uint8_t> png = {};
  static constexpr void fields(auto& s, auto&& visit) {
    visit("frame", s.frame);
    visit("picture", s.picture);
    visit("png", s.png);
    visit("neutral", s.neutral);
  }
};

/// An entry of a picture's legend.
struct LegendEntry {
  std::string style;   ///< of a stroke or mark; or empty
  std::string colour;  ///< CSS colour of a patch; or empty
  std::string text;
  static constexpr void fields(auto& s, auto&& visit) {
    visit("style", s.style);
    visit("colour", s.colour);
    visit("text", s.text);
  }
};

/// What the report keeps of a payload: at most 1400 pixels a side and a few ten thousand vertices,
/// however large it was. It may be kept on the disk.
struct Sketch {
  std::string kind;     ///< `Road graph`
  std::string caption;  ///< its figures: `34 nodes, 41 edges, 12.3 km, 7 loops, 9 dead ends`
  std::optional<Raster> raster;
  std::vector<Stroke> strokes;
  std::vector<Mark> marks;
  std::vector<LegendEntry> legend;
  std::optional<Measures> measures;
  bool points = false;      ///< single points, which want a dark ground
  bool in_map = true;       ///< in the map frame, which has a north; else in a sensor's
  std::uint64_t index = 0;  ///< of the item it was made of
  Stamp stamp = 0;
  static constexpr void fields(auto& s, auto&& visit) {
    visit("kind", s.kind);
    visit("caption", s.caption);
    visit("raster", s.raster);
    visit("strokes", s.strokes);
    visit("marks", s.marks);
    visit("legend", s.legend);
    visit("measures", s.measures);
    visit("points", s.points);
    visit("in_map", s.in_map);
    visit("index", s.index);
    visit("stamp", s.stamp);
  }
};

/// Makes the sketch of a payload of the type the function was found for.
using SketchFunction = std::function<Sketch(const void* payload)>;

}  // namespace stope::report
