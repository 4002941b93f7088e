#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace stope::testing {

/// A rectangle of free cells: columns and rows from the picture's lower left, upper bounds
/// excluded.
struct FreeRectangle {
  int left, bottom, right, top;
};

/// Writes NAME.pgm and NAME.yaml, a map of 1 m cells with its lower left corner at (0, 0), free in
/// the rectangles and occupied elsewhere. Gives the yaml's path.
std::filesystem::path write_small_map(const std::filesystem::path& folder, const std::string& name,
                                      int width, int height,
                                      const std::vector<FreeRectangle>& free);

/// A ring of roads 10 m wide around a block, with a road to a dead end in the east: 120 x 80 m.
std::filesystem::path write_ring_map(const std::filesystem::path& folder);

}  // namespace stope::testing
