#include "plugins/export/conical_yaml.hpp"

#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <vector>

#include "plugins/export/text_bytes.hpp"

namespace stope::exports {
namespace {

/// The shortest decimal that reads back as the same number, with YAML's words for what is none.
std::string number(double value) {
  if (std::isnan(value)) return ".nan";
  if (std::isinf(value)) return value > 0 ? ".inf" : "-.inf";
  return fmt::format("{}", value);
}

/// The centre's pixel: column from the left, row from the top.
std::string pixel(const GridFrame& frame, const Region& region) {
  const Vector2 at = frame.to_grid(region.x, region.y);
  const double column = std::floor(at.x()), row = frame.height - 1 - std::floor(at.y());
  if (!(std::abs(column) < 1e9 && std::abs(row) < 1e9)) return "[-1, -1]";
  return fmt::format("[{:.0f}, {:.0f}]", column + 0.0, row + 0.0);
}

}  // namespace

std::string conical_yaml(const RegionMap& map, const RegionPieces& pieces,
                         const RegionColours& colours, const ConicalSettings& settings) {
  const GridFrame& frame = map.labels.frame;
  const double floor = settings.floor / 255.0;
  std::string text;
  const auto print = [&]<class... Values>(fmt::format_string<Values...> format,
                                          Values&&... values) {
    fmt::format_to(std::back_inserter(text), format, std::forward<Values>(values)...);
  };
  print(
      "# A conical map (Wang et al. 2019, sec. 3): hue tells regions apart, saturation is "
      "occupancy.\n");
  print("image: {}\nresolution: {}\norigin: [{}, {}, {}]\n", json_text(settings.image),
        number(frame.resolution), number(frame.origin.x), number(frame.origin.y),
        number(frame.origin.yaw));
  // In the paper's terms, for who reads the picture by its formulas alone.
  print("mode: {}\nfree_thresh: {}\noccupied_thresh: {}\n", settings.trinary ? "trinary" : "scale",
        settings.trinary ? floor + (1 - floor) * 0.196 : floor,
        settings.trinary ? floor + (1 - floor) * 0.65 : 1.0);
  print("hue_start: 0\nhue_step: {}\nvertices: {}\n", 360 / colours.hues, map.regions.size());
  print("stope:\n  version: 1\n  size: [{}, {}]\n  floor: {}\n  occupancy: {}\n", frame.width,
        frame.height, settings.floor, settings.measured ? "grid" : "assumed");
  if (!map.labels.names.empty()) {
    print("  label_names: [");
    for (std::size_t i = 0; i < map.labels.names.size(); ++i)
      print("{}{}", i == 0 ? "" : ", ", json_text(map.labels.names[i]));
    print("]\n");
  }
  print("  # The region of each connected piece of one hue, in the picture's order.\n  pieces: \"");
  for (std::size_t i = 0; i < pieces.region.size(); ++i)
    print("{}{}", i == 0 ? "" : (i % 24 == 0 ? "\n    " : " "), pieces.region[i]);
  print("\"\ntopology:{}\n", map.regions.empty() ? " []" : "");
  std::vector<std::vector<std::uint32_t>> adjacent(map.regions.size());
  for (std::size_t i = 0; i + 1 < map.adjacency.size(); i += 2) {
    adjacent[map.adjacency[i]].push_back(map.adjacency[i + 1]);
    adjacent[map.adjacency[i + 1]].push_back(map.adjacency[i]);
  }
  for (std::size_t i = 0; i < map.regions.size(); ++i) {
    const Region& region = map.regions[i];
    print("  - {{vertex: {}, pixel: {}, adjacent: [{}]", i, pixel(frame, region),
          fmt::join(adjacent[i], ", "));
    if (!map.semantics.empty()) print(", semantics: {}", json_text(map.semantics[i]));
    print(", id: {}, centre: [{}, {}], axes: [{}, {}, {}], area: {}, hue: {}, cells: {}}}\n",
          region.id, number(region.x), number(region.y), number(region.major), number(region.minor),
          number(region.yaw), number(region.area), colours.of_region[i] * (360 / colours.hues),
          pieces.cells[i]);
  }
  return text;
}

}  // namespace stope::exports
