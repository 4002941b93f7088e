#include "plugins/map_source/labelled_map.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "stope/error.hpp"

namespace stope::map_source {
namespace {

constexpr std::uint32_t kNobody = std::numeric_limits<std::uint32_t>::max();

/// Labels of the grid from the region of each piece.
RegionLabels labels_of(const GridFrame& frame, const ColourPieces& pieces,
                       const std::vector<std::uint32_t>& region) {
  std::vector<std::int32_t> cells(frame.size());
  for (std::int32_t y = 0; y < frame.height; ++y) {
    const std::int32_t* from = pieces.of_pixel.data() + frame.place({0, y});
    std::int32_t* to = cells.data() + frame.place({0, frame.height - 1 - y});
    for (std::int32_t x = 0; x < frame.width; ++x) {
      const std::uint32_t owner = from[x] < 0 ? kNobody : region[static_cast<std::size_t>(from[x])];
      to[x] = owner == kNobody ? 0 : static_cast<std::int32_t>(owner) + 1;
    }
  }
  return {frame, std::move(cells), {}, {}};
}

/// Semantics by region; none if no vertex has any.
std::vector<std::string> semantics_of(const ConicalYaml& map) {
  std::vector<std::string> semantics;
  const bool any = std::any_of(map.vertices.begin(), map.vertices.end(),
                               [](const ConicalVertex& v) { return v.semantics.has_value(); });
  for (const ConicalVertex& vertex : map.vertices) {
    if (any) semantics.push_back(vertex.semantics.value_or(""));
  }
  return semantics;
}

/// Sums over the cells of a region, for its axes.
struct Moments {
  double count = 0, x = 0, y = 0, xx = 0, xy = 0, yy = 0;
};

void measure(RegionMap& map) {
  const GridFrame& frame = map.labels.frame;
  const std::vector<std::int32_t>& labels = map.labels.cells.dense();
  std::vector<Moments> moments(map.regions.size());
  for (std::int32_t row = 0; row < frame.height; ++row) {
    for (std::int32_t column = 0; column < frame.width; ++column) {
      const std::int32_t label = labels[frame.place({column, row})];
      if (label == 0) continue;
      Moments& m = moments[static_cast<std::size_t>(label) - 1];
      const double x = column, y = row;
      m.count += 1, m.x += x, m.y += y, m.xx += x * x, m.xy += x * y, m.yy += y * y;
    }
  }
  for (std::size_t i = 0; i < moments.size(); ++i) {
    const Moments& m = moments[i];
    Region& region = map.regions[i];
    if (m.count == 0) continue;
    region.area = m.count * frame.resolution * frame.resolution;
    const double mean_x = m.x / m.count, mean_y = m.y / m.count;
    const double xx = m.xx / m.count - mean_x * mean_x, yy = m.yy / m.count - mean_y * mean_y;
    const double xy = m.xy / m.count - mean_x * mean_y;
    const double middle = (xx + yy) / 2, spread = std::hypot((xx - yy) / 2, xy);
    // Of an ellipse: its semi-axes are twice the deviations along them.
    region.major = 2 * std::sqrt(std::max(0.0, middle + spread)) * frame.resolution;
    region.minor = 2 * std::sqrt(std::max(0.0, middle - spread)) * frame.resolution;
    region.yaw = 0.5 * std::atan2(2 * xy, xx - yy) + frame.origin.yaw;
  }
}

/// Whose piece is whose, by the paper: the vertex's pixel tells.
class Owners {
 public:
  Owners(const ConicalYaml& map, const PaintedMap& painted, const ColourPieces& pieces)
      : map_(map), painted_(painted), pieces_(pieces), owner_(pieces.hue.size(), kNobody) {}

  std::vector<std::uint32_t> find(std::vector<std::string>& warnings) {
    for (std::size_t i = 0; i < map_.vertices.size(); ++i) {
      const std::int32_t piece = piece_under(map_.vertices[i]);
      if (piece < 0) {
        ++lost_;
        continue;
      }
      std::uint32_t& owner = owner_[static_cast<std::size_t>(piece)];
      if (owner != kNobody) {
        map_.fail(
            map_.vertices[i].line,
            fmt::format("vertices {} and {} lie in one piece of colour, so that their regions "
                        "cannot be told apart",
                        map_.vertices[owner].number, map_.vertices[i].number));
      }
      owner = static_cast<std::uint32_t>(i);
    }
    find_free_pieces();
    for (std::size_t piece = 0; piece < owner_.size(); ++piece) {
      if (owner_[piece] == kNobody && has_free_[piece]) adopt(piece);
    }
    if (lost_ > 0)
      warnings.push_back(fmt::format(
          "{} vertices have no colour at their pixel: cells that are wholly free are white by the "
          "paper's formulas, whatever their region",
          lost_));
    if (adopted_ > 0)
      warnings.push_back(
          fmt::format("{} pieces of colour without a vertex went to the nearest "
                      "vertex of their hue",
                      adopted_));
    return std::move(owner_);
  }

 private:
  std::int32_t piece_under(const ConicalVertex& vertex) const {
    const GridFrame& frame = painted_.grid.frame;
    const double x = std::floor(vertex.pixel_x), y = std::floor(vertex.pixel_y);
    if (!(x >= 0 && y >= 0 && x < frame.width && y < frame.height)) {
      map_.fail(
          vertex.line,
          fmt::format("the pixel ({}, {}) of vertex {} is outside of the picture "
                      "of {} x {} pixels",
                      vertex.pixel_x, vertex.pixel_y, vertex.number, frame.width, frame.height));
    }
    return pieces_
        .of_pixel[frame.place({static_cast<std::int32_t>(x), static_cast<std::int32_t>(y)})];
  }

  // Walls outside of all regions have a hue too, as saturation is all that says occupied.
  void find_free_pieces() {
    const GridFrame& frame = painted_.grid.frame;
    has_free_.assign(owner_.size(), false);
    for (std::int32_t y = 0; y < frame.height; ++y) {
      for (std::int32_t x = 0; x < frame.width; ++x) {
        const std::int32_t piece = pieces_.of_pixel[frame.place({x, y})];
        if (piece < 0) continue;
        const std::uint8_t cell = painted_.grid.cells[frame.place({x, frame.height - 1 - y})];
        if (cell != OccupancyGrid::kOccupied) has_free_[static_cast<std::size_t>(piece)] = true;
      }
    }
  }

  void adopt(std::size_t piece) {
    const GridFrame& frame = painted_.grid.frame;
    const auto width = static_cast<std::uint64_t>(frame.width);
    const auto x = static_cast<double>(pieces_.first[piece] % width);
    const auto y = static_cast<double>(pieces_.first[piece] / width);
    const auto hues = static_cast<std::uint64_t>(std::max(1, 360 / map_.hue_step));
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < map_.vertices.size(); ++i) {
      const ConicalVertex& vertex = map_.vertices[i];
      if (vertex.number % hues != static_cast<std::uint64_t>(pieces_.hue[piece])) continue;
      const double distance = std::hypot(vertex.pixel_x - x, vertex.pixel_y - y);
      if (distance >= nearest) continue;
      nearest = distance;
      owner_[piece] = static_cast<std::uint32_t>(i);
    }
    if (owner_[piece] == kNobody) {
      throw Error(fmt::format(
          "the picture {} has a piece of hue {} degrees from column {}, row {} (from the top) on, "
          "and no vertex of {} has that hue",
          map_.image.string(), map_.hue_start + pieces_.hue[piece] * map_.hue_step, x, y,
          map_.file));
    }
    ++adopted_;
  }

  const ConicalYaml& map_;
  const PaintedMap& painted_;
  const ColourPieces& pieces_;
  std::vector<std::uint32_t> owner_;
  std::vector<bool> has_free_;
  std::size_t lost_ = 0, adopted_ = 0;
};

}  // namespace

RegionMap written_regions(const ConicalYaml& map, const PaintedMap& painted,
                          const ColourPieces& pieces) {
  const StopeConical& stope = *map.stope;
  if (pieces.hue.size() != stope.pieces.size()) {
    map.fail(stope.pieces_line,
             fmt::format("the yaml lists {} pieces of colour, but the picture {} has {}: was it "
                         "edited, or is it another map's?",
                         stope.pieces.size(), map.image.string(), pieces.hue.size()));
  }
  for (const std::uint32_t region : stope.pieces) {
    if (region >= map.vertices.size())
      map.fail(stope.pieces_line,
               fmt::format("a piece of colour belongs to vertex {}, but there are {}", region,
                           map.vertices.size()));
  }
  RegionMap regions;
  regions.adjacency = adjacency_of(map);
  regions.semantics = semantics_of(map);
  regions.labels = labels_of(painted.grid.frame, pieces, stope.pieces);
  regions.labels.names = stope.label_names;
  std::vector<std::uint64_t> cells(map.vertices.size());
  for (const std::int32_t label : regions.labels.cells.dense()) {
    if (label > 0) ++cells[static_cast<std::size_t>(label) - 1];
  }
  for (std::size_t i = 0; i < map.vertices.size(); ++i) {
    const ConicalVertex& vertex = map.vertices[i];
    regions.regions.push_back(vertex.region);
    if (cells[i] != vertex.cells) {
      map.fail(
          vertex.line,
          fmt::format("vertex {} (region {}) has {} cells by the yaml, and {} in the picture "
                      "{}: was one of them edited?",
                      vertex.number, vertex.region.id, vertex.cells, cells[i], map.image.string()));
    }
  }
  return regions;
}

RegionMap painted_regions(const ConicalYaml& map, const PaintedMap& painted,
                          const ColourPieces& pieces, std::vector<std::string>& warnings) {
  RegionMap regions;
  regions.adjacency = adjacency_of(map);
  regions.semantics = semantics_of(map);
  const GridFrame& frame = painted.grid.frame;
  regions.labels = labels_of(frame, pieces, Owners(map, painted, pieces).find(warnings));
  for (std::size_t i = 0; i < map.vertices.size(); ++i) {
    const ConicalVertex& vertex = map.vertices[i];
    if (i > 0 && vertex.number <= map.vertices[i - 1].number)
      map.fail(vertex.line, "the numbers of the vertices do not increase");
    // Eq. 9 gives the pixel's upper left corner; the place is its middle.
    const Vector2 at = frame.to_map(vertex.pixel_x + 0.5, frame.height - vertex.pixel_y - 0.5);
    Region region;
    region.id = vertex.number;
    region.x = at.x(), region.y = at.y();
    regions.regions.push_back(region);
  }
  measure(regions);
  return regions;
}

}  // namespace stope::map_source
