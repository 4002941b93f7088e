#pragma once

#include <cstdint>
#include <vector>

#include "plugins/source/synthetic_pit/layout.hpp"

namespace stope::source {

/// What the roads ask of a place.
struct RoadSample {
  double outside = 0;           ///< metres outside the drivable area; negative inside
  double level = 0;             ///< elevation of the road surface here or at the nearest road
  double lower = 0, upper = 0;  ///< elevations between which banks let the ground be
};

/// The drivable area as a signed distance, and the road surface, as functions of the place.
///
/// The area is the union of all streets' strips and turning places; where streets meet, corners are
/// rounded by circles. In road sections, more than half a width and a fillet away from junctions
/// and turning places, both edges are exactly half a width from the centre line.
class RoadField {
 public:
  /// Keeps a reference to `layout`. `rough` is the amplitude of freshly dug faces, metres.
  RoadField(const Layout& layout, double rough, std::uint64_t seed);

  /// The parts of the network that matter inside a circle.
  class Tile {
   private:
    friend class RoadField;
    struct Candidate {
      std::size_t section;
      std::vector<std::uint32_t> segments;
    };
    std::vector<Candidate> candidates;
    std::vector<std::size_t> attachments;
  };
  Tile tile(const Vector2& centre, double radius) const;
  /// What the roads ask of a place inside the tile.
  RoadSample sample(const Tile& tile, const Vector2& place) const;

 private:
  /// A short run of a street, the unit of search.
  struct Section {
    std::size_t street = 0;
    std::size_t first = 0, last = 0;  ///< points; the last may be the street's count, which wraps
    Vector2 centre = Vector2::Zero();
    double radius = 0;
    double reach = 0;                   ///< metres beyond the road's edge that its banks may go on
    const DeadEnd* dead_end = nullptr;  ///< a turning place at one of its ends
    bool starts_attached = false, ends_attached = false;
  };
  struct Near {
    std::size_t street = 0;
    double outside = 0, level = 0;
  };
  Near nearest(const Section& section, const std::vector<std::uint32_t>& segments,
               const Vector2& place) const;
  double turning_place(const DeadEnd& end, const Vector2& place) const;
  void add_sections(std::size_t street);
  double bank_reach(const Section& section) const;

  const PitShape& shape_;
  const StreetNetwork& network_;
  const NetworkRules& rules_;
  double rough_;
  std::uint64_t seed_;
  std::vector<Section> sections_;
};

}  // namespace stope::source
