#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "plugins/map_source/cell_rule.hpp"
#include "stope/payloads/region_map.hpp"

namespace stope::map_source {

/// A topological vertex as the yaml has it.
struct ConicalVertex {
  int line = 0;                         ///< of the yaml, from 1
  std::uint64_t number = 0;             ///< how others call it
  double pixel_x = 0, pixel_y = 0;      ///< column from the left, row from the top
  std::vector<std::uint64_t> adjacent;  ///< numbers
  std::optional<std::string> semantics;
  Region region;            ///< of a map that Stope wrote
  std::uint64_t cells = 0;  ///< of a map that Stope wrote
};

/// What only maps that Stope wrote say.
struct StopeConical {
  std::int32_t width = 0, height = 0;
  int floor = 0;         ///< chroma of free cells, of 255
  bool measured = true;  ///< occupancy was a grid's
  std::vector<std::string> label_names;
  std::vector<std::uint32_t> pieces;  ///< region of each piece of colour, in the picture's order
  int pieces_line = 0;
};

/// What the yaml of a conical map says (Wang et al., sec. 3.3).
struct ConicalYaml {
  std::string file;
  std::filesystem::path image;
  double resolution = 0;
  Pose2 origin;
  CellRule rule;                     ///< mode and thresholds, of occupancy
  int hue_start = 0, hue_step = 20;  ///< degrees: a and b of eq. 6
  double coefficient = 1;            ///< k of eq. 6
  std::vector<ConicalVertex> vertices;
  std::optional<StopeConical> stope;

  [[noreturn]] void fail(int line, const std::string& what) const;
};

/// Reads the yaml of a conical map and checks it against itself. Throws Error, naming the line.
ConicalYaml read_conical_yaml(const std::filesystem::path& file);

/// The adjacency as a RegionMap has it: pairs of places in `vertices`. Throws Error where a vertex
/// names a neighbour that is not there, or that does not name it in turn.
std::vector<std::uint32_t> adjacency_of(const ConicalYaml& map);

}  // namespace stope::map_source
