#include "small_map.hpp"

#include "stope_process.hpp"

namespace stope::testing {

std::filesystem::path write_small_map(const std::filesystem::path& folder, const std::string& name,
                                      int width, int height,
                                      const std::vector<FreeRectangle>& free) {
  std::string pixels(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), '\0');
  for (const FreeRectangle& rectangle : free) {
    for (int row = rectangle.bottom; row < rectangle.top; ++row) {
      for (int column = rectangle.left; column < rectangle.right; ++column) {
        pixels[static_cast<std::size_t>(height - 1 - row) * static_cast<std::size_t>(width) +
               static_cast<std::size_t>(column)] = '\xff';
      }
    }
  }
  write_file(folder / (name + ".pgm"),
             "P5\n" + std::to_string(width) + " " + std::to_string(height) + "\n255\n" + pixels);
  write_file(folder / (name + ".yaml"),
             "image: " + name +
                 ".pgm\nresolution: 1.0\norigin: [0.0, 0.0, 0.0]\nnegate: 0\n"
                 "occupied_thresh: 0.65\nfree_thresh: 0.196\n");
  return folder / (name + ".yaml");
}

std::filesystem::path write_ring_map(const std::filesystem::path& folder) {
  return write_small_map(
      folder, "ring", 120, 80,
      {{10, 10, 70, 20}, {10, 60, 70, 70}, {10, 10, 20, 70}, {60, 10, 70, 70}, {60, 35, 112, 45}});
}

}  // namespace stope::testing
