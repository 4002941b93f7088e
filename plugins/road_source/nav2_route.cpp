#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <limits>
#include <string>

#include "plugins/road_source/feature_reader.hpp"
#include "plugins/road_source/route_assembly.hpp"
#include "stope/stope.hpp"

namespace stope::road_source {
namespace {

std::string bytes_of(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary | std::ios::ate);
  const std::streamoff size = stream ? static_cast<std::streamoff>(stream.tellg()) : -1;
  std::string bytes(static_cast<std::size_t>(size < 0 ? 0 : size), '\0');
  stream.seekg(0);
  stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  if (!stream) throw Error(fmt::format("the road graph {} cannot be read", file.string()));
  return bytes;
}

}  // namespace

class Nav2Route final : public Stage {
 public:
  struct Params {
    std::filesystem::path graph;
    double clearance = 0;
  } params;
  OutValue<RoadGraph> roads;

  static void describe(About<Nav2Route>& about) {
    about.summary("Reads a road graph from the GeoJSON of nav2's route server.")
        .from("nav2_route, GeoJsonGraphFileLoader")
        .notes(
            "What export/nav2_route wrote comes back to the last bit, closed roads included. In "
            "graphs of others each edge is a road one way, two opposite ones a road both ways; "
            "abs_speed_limit is its speed limit. What a road graph has no place for (costs, "
            "operations, other metadata) is named in a warning.")
        .output("roads", &Nav2Route::roads, "The road graph, in canonical order.")
        .param("graph", &Params::graph, required() + existing(PathKind::kFile), "The GeoJSON file.")
        .param("clearance", &Params::clearance, "m", at_least(0.0),
               "Free room on either side of roads whose file says nothing of it; their width is "
               "twice that.");
  }

  void run(Context& context) override {
    const std::string file = params.graph.string();
    const std::string text = bytes_of(params.graph);
    const Collection collection = scan_features(text, file);
    if (collection.features.size() > std::numeric_limits<std::uint32_t>::max() / 4)
      throw Error(fmt::format("the road graph {} has more features than can be counted", file));
    FeatureReader reader(file);
    for (const auto& [name, member] : collection.members) reader.read_member(name, member);
    std::uint32_t number = 0;
    for (const FeatureText& feature : collection.features) {
      reader.read(feature, ++number);
      if (number % 4096 == 0) {
        context.stop_if_cancelled();
        context.progress(static_cast<double>(number) /
                         static_cast<double>(collection.features.size()));
      }
    }
    AssembledRoads assembled = assemble(reader.take(), {params.clearance}, file);
    for (const std::string& warning : assembled.warnings)
      context.warn(fmt::format("the road graph {}: {}", file, warning));
    if (assembled.roads.edges.empty())
      context.warn(fmt::format("the road graph {} has no roads", file));
    context.info(fmt::format("read {} nodes and {} roads", assembled.roads.nodes.size(),
                             assembled.roads.edges.size()));
    roads.set(std::move(assembled.roads));
  }
};

STOPE_STAGE(Nav2Route, "road_source/nav2_route")

}  // namespace stope::road_source
