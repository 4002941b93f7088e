#include "made_comparison.hpp"

#include <fmt/format.h>

#include <array>
#include <fstream>
#include <functional>

#include "framework/report/draw/png.hpp"
#include "stope/random.hpp"

namespace stope::made {
namespace {

constexpr std::array kArmNames{"watershed", "voronoi", "skeleton", "region_growing", "manual"};

void put(const std::filesystem::path& file, const std::string& bytes) {
  std::filesystem::create_directories(file.parent_path());
  std::ofstream(file, std::ios::binary) << bytes;
}

std::string line(const std::string& coordinates) {
  return "{\"type\": \"Feature\", \"properties\": {}, \"geometry\": {\"type\": \"LineString\", "
         "\"coordinates\": [" +
         coordinates + "]}}";
}

/// A ring of 400 by 300 m that all arms have, in both directions as nav2 wants it, and a dead end
/// for each arm but the first.
std::string roads(std::size_t arm, std::size_t recording) {
  const double wide = 400 + 10.0 * static_cast<double>(recording);
  std::string features;
  for (const auto& [a, b] : {std::pair(std::pair(0.0, 0.0), std::pair(wide, 0.0)),
                             {{wide, 0.0}, {wide, 300.0}},
                             {{wide, 300.0}, {0.0, 300.0}},
                             {{0.0, 300.0}, {0.0, 0.0}}})
    for (const bool back : {false, true})
      features += line(fmt::format("[{}, {}], [{}, {}]", back ? b.first : a.first,
                                   back ? b.second : a.second, back ? a.first : b.first,
                                   back ? a.second : b.second)) +
                  ",\n";
  for (std::size_t k = 1; k <= arm; ++k)
    features += line(fmt::format("[{0}, 300], [{0}, {1}]", 60 * k, 300 + 70 * k)) + ",\n";
  features += line("[0, 0], [-20, -20]");
  return "{\"type\": \"FeatureCollection\", \"features\": [\n" + features + "\n]}\n";
}

std::string picture(std::size_t arm, std::size_t recording) {
  report::Picture picture{320, 240, {}};
  picture.pixels.resize(320 * 240);
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x) {
      const bool bar = x / 24 == static_cast<int>((2 + 3 * arm + recording) % 13);
      const auto grey = static_cast<std::uint8_t>(205 + (x / 16 + y / 16) % 2 * 30);
      picture.at(x, y) =
          bar ? report::Colour{196, 72, static_cast<std::uint8_t>(14 + 40 * arm), 255}
              : report::Colour{grey, grey, grey, 255};
    }
  const std::vector<std::uint8_t> bytes = report::encode_png(picture);
  return {bytes.begin(), bytes.end()};
}

/// A map of 100 by 75 cells of 4 m whose left half is an obstacle.
std::string map_picture() {
  std::string pgm = "P5\n100 75\n255\n";
  for (int row = 0; row < 75; ++row) pgm += std::string(50, '\0') + std::string(50, '\xfe');
  return pgm;
}

void add_file(Comparison& comparison, ComparedCell& cell, const std::string& output,
              CellArtefact::Kind kind, const std::string& bytes,
              const std::string& companion = "") {
  const std::string path = cell.folder + "/outputs/" + (companion.empty() ? output : companion);
  put(comparison.folder / path, bytes);
  // Not SHA-256, but as different as the bytes are.
  const std::string sum = fmt::format("{:064x}", std::hash<std::string>()(bytes));
  cell.artefacts.push_back({output, path, sum, bytes.size(), kind, !companion.empty()});
}

}  // namespace

Comparison comparison_in(const std::filesystem::path& folder, const ComparisonShape& shape) {
  Comparison made;
  made.name = shape.name;
  made.file = "pipelines/compare/extractors.yaml";
  made.base = "pipelines/measure/true_grid.yaml";
  made.folder = folder;
  made.id = "c0ffee";
  made.version = "0.1.0";
  made.started = "2026-11-28T04:00:00.000Z";
  made.ended = "2026-11-28T04:03:10.000Z";
  made.threads = 2;
  made.complete = true;
  for (std::size_t arm = 0; arm < shape.arms; ++arm)
    made.arms.push_back({kArmNames[arm],
                         {fmt::format("roads.use=topology/{}", kArmNames[arm])},
                         {fmt::format("roads = topology/{}(in: scans.truth_grid)", kArmNames[arm])},
                         {}});
  for (std::size_t i = 0; i < shape.recordings; ++i)
    made.recordings.push_back({fmt::format("pit-{}", i), {fmt::format("pit.seed={}", i + 1)}, {}});
  for (std::size_t i = 0; i < shape.seeds; ++i) made.seeds.push_back(i);
  made.metrics = {{"apls", "apls", "apls", Direction::kHigher, 0.02, ""},
                  {"detour", "detour", "detour_p95", Direction::kLower, 0.01, "m"},
                  {"coverage", "coverage", "coverage", Direction::kHigher, 0.05, ""}};
  Random random(7);
  for (std::size_t recording = 0; recording < shape.recordings; ++recording)
    for (std::size_t seed = 0; seed < shape.seeds; ++seed)
      for (std::size_t arm = 0; arm < shape.arms; ++arm) {
        ComparedCell cell;
        cell.arm = arm, cell.recording = recording, cell.seed = seed;
        cell.run_seed = made.seeds[seed];
        cell.status = CellStatus::kDone;
        cell.key = fmt::format("{:032x}", 1 + made.cells.size());
        cell.folder = fmt::format("arms/{}/pit-{}/{}", kArmNames[arm], recording, seed);
        cell.measures = {0.6 + shape.difference * static_cast<double>(arm) + 0.03 * random.normal(),
                         1.2 + 0.05 * random.normal(), 0.9 + 0.002 * random.normal()};
        cell.stages = {{"scans", "source/synthetic_pit", StageFate::kShared, 1.2, 110},
                       {"roads", fmt::format("topology/{}", kArmNames[arm]), StageFate::kRan,
                        0.05 * (1 + static_cast<double>(arm)) + 0.01 * random.uniform(), 1},
                       {"apls", "metric/apls", StageFate::kRan, 0.3, 1}};
        if (shape.files) {
          add_file(made, cell, "roads.png", CellArtefact::Kind::kPicture, picture(arm, recording));
          add_file(made, cell, "roads.geojson", CellArtefact::Kind::kGeojson,
                   roads(arm, recording));
          add_file(made, cell, "map.yaml", CellArtefact::Kind::kOther,
                   "image: map.pgm\nresolution: 4\norigin: [0, 0, 0]\n");
          add_file(made, cell, "map.yaml", CellArtefact::Kind::kOther, map_picture(), "map.pgm");
        }
        made.cells.push_back(cell);
      }
  return made;
}

}  // namespace stope::made
