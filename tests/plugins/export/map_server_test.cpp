#include <gtest/gtest.h>

#include "tests/plugins/export/export_samples.hpp"
#include "tests/plugins/stage_harness.hpp"

extern "C" const stope::StageEntry* stope_stage_MapServer();

namespace stope::exports {
namespace {

OccupancyGrid sample_grid() {
  OccupancyGrid grid;
  grid.frame = {3, 2, 0.05, {-6.299999999999997, 1e7 + 0.1, 0.5}};
  // Lower row, then upper: 254 * 0.196 is 49.8, 254 * 0.65 is 165.1.
  grid.cells = {0, 254, 255, 49, 50, 166};
  return grid;
}

TEST(ExportMapServer, WritesThreeValuesTopRowFirst) {
  const Artefact artefact = stope::testing::StageHarness(stope_stage_MapServer())
                                .input("grid", sample_grid())
                                .set("stem", std::string("pit"))
                                .apply<Artefact>();
  ASSERT_EQ(artefact.files.size(), 2U);
  EXPECT_EQ(artefact.files[0].extension, "yaml");
  EXPECT_EQ(text_of(artefact, "pgm"),
            std::string("P5\n3 2\n255\n") + "\xfe\xcd" + '\0' + "\xfe" + '\0' + "\xcd");
  const std::string yaml = text_of(artefact, "yaml");
  EXPECT_NE(yaml.find("image: pit.pgm\n"), std::string::npos);
  EXPECT_NE(yaml.find("resolution: 0.05\n"), std::string::npos);
  EXPECT_NE(yaml.find("origin: [-6.299999999999997, 10000000.1, 0.5]\n"), std::string::npos);
  EXPECT_NE(yaml.find("free_thresh: 0.196\n"), std::string::npos);
}

TEST(ExportMapServer, UnknownReadsBackAsUnknown) {
  const double occupied = (255 - 205) / 255.0;  // how map_server reads the pixel
  EXPECT_GT(occupied, 0.196);
  EXPECT_LT(occupied, 0.65);
}

}  // namespace
}  // namespace stope::exports
