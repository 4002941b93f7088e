// How large and how fast the lossless formats are: a route graph of a million nodes, a conical map
// of 10 000 rooms. Thread CPU time, least and median of several runs.
#include <fmt/format.h>
#include <time.h>

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <functional>
#include <string>
#include <vector>

#include "plugins/export/conical_files.hpp"
#include "plugins/export/route_writer.hpp"
#include "stope/digest.hpp"
#include "stope/testing/stage_harness.hpp"

extern "C" const stope::StageEntry* stope_stage_Nav2Route();
extern "C" const stope::StageEntry* stope_stage_ConicalMap();

namespace stope {
namespace {

double cpu_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

void time(const char* what, int runs, const std::function<void()>& work) {
  std::vector<double> seconds;
  for (int i = 0; i < runs; ++i) {
    const double begin = cpu_seconds();
    work();
    seconds.push_back(cpu_seconds() - begin);
  }
  std::sort(seconds.begin(), seconds.end());
  fmt::print("  {:<10} least {:.2f} s, median {:.2f} s of {}\n", what, seconds.front(),
             seconds[seconds.size() / 2], runs);
  std::fflush(stdout);
}

/// Crossings in a square with a road to the right and one up, every fifth of them with two bends.
RoadGraph city(std::uint32_t side) {
  RoadGraph graph;
  Random random(1);
  for (std::uint32_t i = 0; i < side * side; ++i) {
    graph.nodes.push_back({0, 50.0 * (i % side) + random.uniform(0, 20),
                           50.0 * (i / side) + random.uniform(0, 20), random.uniform(900, 1400)});
  }
  const auto join = [&](std::uint32_t from, std::uint32_t to) {
    RoadEdge edge;
    edge.from = from, edge.to = to;
    edge.first_vertex = static_cast<std::uint32_t>(graph.vertices.size());
    const RoadNode &a = graph.nodes[from], &b = graph.nodes[to];
    graph.vertices.push_back({a.x, a.y, a.z, 5});
    const int bends = random.below(5) == 0 ? 2 : 0;
    for (int k = 1; k <= bends; ++k) {
      const double t = k / 3.0;
      graph.vertices.push_back({a.x + t * (b.x - a.x) + random.uniform(),
                                a.y + t * (b.y - a.y) + random.uniform(), 1000, 6});
    }
    graph.vertices.push_back({b.x, b.y, b.z, 5});
    edge.vertex_count = static_cast<std::uint32_t>(bends) + 2;
    edge.width = random.uniform(8, 30);
    edge.closed = random.below(50) == 0 ? 1 : 0;
    graph.edges.push_back(edge);
  };
  for (std::uint32_t i = 0; i < side * side; ++i) {
    if (i % side + 1 < side) join(i, i + 1);
    if (i / side + 1 < side) join(i, i + side);
  }
  canonicalize(graph);
  return graph;
}

void routes(std::uint32_t side, int runs) {
  const RoadGraph graph = city(side);
  std::string text;
  fmt::print("nav2 route graph, {} nodes, {} roads\n", graph.nodes.size(), graph.edges.size());
  time("write", runs, [&] { text = exports::route_geojson(graph, {"map", 0.05}); });
  testing::MemoryContext folder;
  const auto file = folder.temporary_folder() / "roads.geojson";
  std::ofstream(file, std::ios::binary) << text;
  fmt::print("  {:.0f} MB\n", static_cast<double>(text.size()) / 1e6);
  text = {};
  bool same = true;
  time("read", runs, [&] {
    testing::StageHarness stage(stope_stage_Nav2Route());
    testing::MemoryOutput<RoadGraph> roads;
    stage.set("graph", file.string()).connect_output("roads", roads).run();
    same = same && digest_of(*roads.items.at(0).value) == digest_of(graph);
  });
  fmt::print("  read back {}\n", same ? "to the last bit" : "OTHERWISE");
}

/// Rooms of 35 x 35 cells with walls and doors between, `side` a row.
void rooms(std::int32_t side, int runs) {
  RegionMap map;
  map.labels.frame = {side * 40, side * 40, 0.05, {}};
  map.labels.cells.dense().assign(map.labels.frame.size(), 0);
  OccupancyGrid grid;
  grid.frame = map.labels.frame;
  grid.cells.assign(grid.frame.size(), OccupancyGrid::kOccupied);
  for (std::int32_t i = 0; i < side * side; ++i) {
    const std::int32_t column = i % side, row = i / side;
    map.regions.push_back({static_cast<std::uint64_t>(i) + 1, column * 2.0 + 0.9, row * 2.0 + 0.9,
                           1, 1, 0, 35 * 35 * 0.0025});
    const auto place = static_cast<std::uint32_t>(i);
    if (column + 1 < side) map.adjacency.insert(map.adjacency.end(), {place, place + 1});
    if (row + 1 < side)
      map.adjacency.insert(map.adjacency.end(), {place, place + static_cast<std::uint32_t>(side)});
    for (std::int32_t y = 0; y < 40; ++y) {
      for (std::int32_t x = 0; x < 40; ++x) {
        const bool door = (x >= 35 && y < 6) || (y >= 35 && x < 6);
        if (!door && (x >= 35 || y >= 35)) continue;
        const std::size_t cell = grid.frame.place({column * 40 + x, row * 40 + y});
        map.labels.cells.dense()[cell] = i + 1;
        grid.cells[cell] = OccupancyGrid::kFree;
      }
    }
  }
  fmt::print("conical map, {} regions on {} x {} cells\n", map.regions.size(),
             map.labels.frame.width, map.labels.frame.height);
  testing::MemoryContext context;
  Artefact files;
  time("write", runs, [&] { files = exports::conical_files(map, &grid, {"map", 0.35}, context); });
  const double plain = static_cast<double>(grid.frame.size()) + 15;
  fmt::print("  PPM {:.2f} MB, {:.4f} times the PGM; yaml {:.2f} MB\n",
             static_cast<double>(files.files[0].bytes.size()) / 1e6,
             static_cast<double>(files.files[0].bytes.size()) / plain,
             static_cast<double>(files.files[1].bytes.size()) / 1e6);
  const auto folder = context.temporary_folder();
  for (const ArtefactFile& file : files.files) {
    std::ofstream(folder / ("map." + file.extension), std::ios::binary)
        .write(reinterpret_cast<const char*>(file.bytes.data()),
               static_cast<std::streamsize>(file.bytes.size()));
  }
  bool same = true;
  time("read", runs, [&] {
    testing::StageHarness stage(stope_stage_ConicalMap());
    testing::MemoryOutput<OccupancyGrid> read_grid;
    testing::MemoryOutput<RegionMap> read_regions;
    stage.set("map", (folder / "map.yaml").string())
        .connect_output("grid", read_grid)
        .connect_output("regions", read_regions)
        .run();
    same = same && digest_of(*read_regions.items.at(0).value) == digest_of(map) &&
           digest_of(*read_grid.items.at(0).value) == digest_of(grid);
  });
  fmt::print("  read back {}\n", same ? "to the last bit" : "OTHERWISE");
}

}  // namespace
}  // namespace stope

int main() {
  stope::rooms(10, 5);
  stope::rooms(100, 3);
  stope::routes(100, 5);
  stope::routes(1000, 1);
  return 0;
}
