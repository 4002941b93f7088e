#include "framework/compare/report/map_underlay.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <numbers>

#include "made_comparison.hpp"
#include "tests/framework/report/made_run.hpp"

namespace stope::report {
namespace {

class MapUnderlayTest : public ::testing::Test {
 protected:
  std::filesystem::path write(const std::string& name, const std::string& text) {
    std::ofstream(folder_.path / name, std::ios::binary) << text;
    return folder_.path / name;
  }
  made::Folder folder_;
};

constexpr const char* kYaml =
    "image: mine.pgm\nmode: trinary\nresolution: 0.5\norigin: [10, -20, 0.25]\nnegate: 0\n"
    "occupied_thresh: 0.65\nfree_thresh: 0.196\n";

TEST_F(MapUnderlayTest, ReadsWhatAMapServerWouldRead) {
  const auto yaml = write("map.yaml", kYaml);
  write("mine.pgm", std::string("P5\n3 2\n255\n") + "\xfe" + '\0' + "\xcd\xfe\xfe\xfe");
  const auto map = read_map(yaml);
  ASSERT_TRUE(map);
  EXPECT_EQ(map->frame.width, 3);
  EXPECT_EQ(map->frame.height, 2);
  EXPECT_EQ(map->frame.resolution, 0.5);
  EXPECT_EQ(map->frame.origin.x, 10);
  EXPECT_EQ(map->frame.origin.y, -20);
  EXPECT_EQ(map->frame.origin.yaw, 0.25);
  EXPECT_EQ(std::string(map->png.begin() + 1, map->png.begin() + 4), "PNG");
}

TEST_F(MapUnderlayTest, IsNoneOfWhatIsNoSuchMap) {
  const auto yaml = write("map.yaml", kYaml);
  EXPECT_FALSE(read_map(yaml)) << "no picture";
  write("mine.pgm", "P5\n3 2\n255\nabc");
  EXPECT_FALSE(read_map(yaml)) << "cut off";
  write("mine.pgm", "P2\n3 2\n255\n0 0 0 0 0 0");
  EXPECT_FALSE(read_map(yaml)) << "as text";
  write("mine.pgm", "P5\n3 -2\n255\nabcdef");
  EXPECT_FALSE(read_map(yaml)) << "less than no rows";
  write("mine.pgm", "P5\n3 2\n255\nabcdef");
  EXPECT_TRUE(read_map(yaml));
  EXPECT_FALSE(
      read_map(write("other.yaml", "resolution: 0\norigin: [0, 0, 0]\nimage: mine.pgm\n")));
  EXPECT_FALSE(read_map(write("else.yaml", "roads: 7\n")));
  EXPECT_FALSE(read_map(folder_.path / "gone.yaml"));
}

// A corner of the map, turned as SVG turns it, must lie where the sheet draws that point.
TEST(MapPlacement, PutsEachCornerWhereLinesWouldBe) {
  GridFrame frame;
  frame.width = 40;
  frame.height = 30;
  frame.resolution = 0.5;
  frame.origin = {3, 4, 0.3};
  Sheet sheet;
  sheet.extent.include({{{-10, -20}, {40, 30}}});
  const double units = 1000.0 / 50;
  const Placement place = placement_of(frame, sheet);
  double degrees = 0, about_x = 0, about_y = 0;
  ASSERT_EQ(
      std::sscanf(place.transform.c_str(), "rotate(%lf %lf %lf)", &degrees, &about_x, &about_y), 3);
  const double angle = degrees * std::numbers::pi / 180;
  for (const double column : {0.0, 40.0})
    for (const double row : {0.0, 30.0}) {
      const double x = place.x + column / 40 * place.width - about_x;
      const double y = place.y + (1 - row / 30) * place.height - about_y;
      const Vector2 wanted = frame.to_map(column, row);
      EXPECT_NEAR(about_x + std::cos(angle) * x - std::sin(angle) * y, (wanted.x() + 10) * units,
                  0.1);
      EXPECT_NEAR(about_y + std::sin(angle) * x + std::cos(angle) * y, (30 - wanted.y()) * units,
                  0.1);
    }
}

}  // namespace
}  // namespace stope::report
