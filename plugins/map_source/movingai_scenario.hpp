#pragma once

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "stope/error.hpp"
#include "stope/payloads/grid_frame.hpp"

namespace stope::map_source {

/// One query of a MovingAI scenario: from one cell of a map to another.
struct MovingAiQuery {
  std::int32_t bucket = 0;             ///< floor(length / 4)
  std::string map;                     ///< file name of the map, as the scenario has it
  std::int32_t width = 0, height = 0;  ///< cells of that map
  std::int32_t start_x = 0, start_y = 0, goal_x = 0, goal_y = 0;  ///< cells, row 0 at the top
  double length = 0;  ///< cells; of the shortest octile path that cuts no corner

  /// The same cells in a grid that read_movingai_map() made: row 0 is the lowest there.
  Cell start() const { return {start_x, height - 1 - start_y}; }
  Cell goal() const { return {goal_x, height - 1 - goal_y}; }
};

/// Reads a MovingAI `.scen` (version 1): `bucket map width height start_x start_y goal_x goal_y
/// length` a line, separated by tabs or blanks. For benchmarks and tests; a header alone, so that
/// they need no plugin. Throws Error, naming file and line.
inline std::vector<MovingAiQuery> read_movingai_scenario(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw Error("the scenario " + file.string() + " cannot be opened");
  std::vector<MovingAiQuery> queries;
  int number = 0;
  const auto fail = [&](const std::string& what) {
    throw Error("the scenario " + file.string() + ":" + std::to_string(number) + ": " + what);
  };
  for (std::string line; std::getline(stream, line);) {
    ++number;
    if (!line.empty() && line.back() == '\r') line.pop_back();
    if (number == 1) {
      if (line.rfind("version 1", 0) != 0) fail("expected 'version 1', the only one there is");
      continue;
    }
    if (line.find_first_not_of(" \t") == std::string::npos) continue;
    std::istringstream words(line);
    words.imbue(std::locale::classic());
    MovingAiQuery query;
    std::string more;
    if (!(words >> query.bucket >> query.map >> query.width >> query.height >> query.start_x >>
          query.start_y >> query.goal_x >> query.goal_y >> query.length) ||
        words >> more) {
      fail("expected bucket, map, width, height, start x and y, goal x and y, length");
    }
    const auto inside = [&](std::int32_t x, std::int32_t y) {
      return x >= 0 && y >= 0 && x < query.width && y < query.height;
    };
    if (!inside(query.start_x, query.start_y) || !inside(query.goal_x, query.goal_y))
      fail("start or goal is outside of the map's " + std::to_string(query.width) + " x " +
           std::to_string(query.height) + " cells");
    if (!(query.length >= 0) || !std::isfinite(query.length)) fail("the length is no length");
    queries.push_back(std::move(query));
  }
  if (number == 0) fail("the file is empty");
  return queries;
}

}  // namespace stope::map_source
