#include <gtest/gtest.h>

#include <cstring>
#include <sstream>

#include "tests/plugins/export/export_samples.hpp"
#include "tests/plugins/stage_harness.hpp"

extern "C" const stope::StageEntry* stope_stage_Pcd();
extern "C" const stope::StageEntry* stope_stage_Ply();

namespace stope::exports {
namespace {

PointCloud sample_cloud(const Vector3& origin) {
  PointCloud cloud;
  cloud.origin = origin;
  cloud.points = {{1.5F, -2.25F, 0.125F}, {0, 3, 4}};
  cloud.intensity = {0.5F, 7};
  cloud.label = {1, 4};
  return cloud;
}

// Header lines up to and including `last`, and what follows them.
std::pair<std::vector<std::string>, std::string> split(const std::string& text,
                                                       const std::string& last) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  std::string line;
  while (std::getline(stream, line)) {
    lines.push_back(line);
    if (line == last) break;
  }
  return {lines, text.substr(static_cast<std::size_t>(stream.tellg()))};
}

template <class T>
T read(const std::string& bytes, std::size_t at) {
  T value{};
  std::memcpy(&value, bytes.data() + at, sizeof(value));
  return value;
}

bool has(const std::vector<std::string>& lines, const std::string& line) {
  return std::find(lines.begin(), lines.end(), line) != lines.end();
}

TEST(Pcd, NearZeroIsSinglePrecisionInTheMapFrame) {
  const auto artefact = stope::testing::StageHarness(stope_stage_Pcd())
                            .input("cloud", sample_cloud(Vector3(1000, 0, -2000)))
                            .apply<Artefact>();
  const auto [lines, data] = split(text_of(artefact, "pcd"), "DATA binary");
  EXPECT_TRUE(has(lines, "FIELDS x y z intensity label"));
  EXPECT_TRUE(has(lines, "SIZE 4 4 4 4 1"));
  EXPECT_TRUE(has(lines, "TYPE F F F F U"));
  EXPECT_TRUE(has(lines, "COUNT 1 1 1 1 1"));
  EXPECT_TRUE(has(lines, "POINTS 2"));
  ASSERT_EQ(data.size(), 2U * 17);
  EXPECT_EQ(read<float>(data, 0), 1001.5F);
  EXPECT_EQ(read<float>(data, 8), -1999.875F);
  EXPECT_EQ(read<float>(data, 17 + 12), 7.0F);
  EXPECT_EQ(read<std::uint8_t>(data, 17 + 16), 4);
}

TEST(Pcd, FarFromZeroIsDouble) {
  const auto artefact = stope::testing::StageHarness(stope_stage_Pcd())
                            .input("cloud", sample_cloud(Vector3(431'000, 4'512'000, 0)))
                            .apply<Artefact>();
  const auto [lines, data] = split(text_of(artefact, "pcd"), "DATA binary");
  EXPECT_TRUE(has(lines, "SIZE 8 8 8 4 1"));
  EXPECT_EQ(read<double>(data, 8), 4'511'997.75);
}

TEST(Ply, HoldsWhatTheHeaderSays) {
  PointCloud cloud = sample_cloud(Vector3::Zero());
  cloud.label.clear();
  const auto artefact =
      stope::testing::StageHarness(stope_stage_Ply()).input("cloud", cloud).apply<Artefact>();
  const auto [lines, data] = split(text_of(artefact, "ply"), "end_header");
  EXPECT_EQ(lines,
            (std::vector<std::string>{"ply", "format binary_little_endian 1.0", "element vertex 2",
                                      "property float x", "property float y", "property float z",
                                      "property float intensity", "end_header"}));
  ASSERT_EQ(data.size(), 2U * 16);
  EXPECT_EQ(read<float>(data, 4), -2.25F);
  EXPECT_EQ(read<float>(data, 16 + 8), 4.0F);
}

TEST(Ply, AnEmptyCloudIsAnEmptyFile) {
  const auto artefact = stope::testing::StageHarness(stope_stage_Ply())
                            .input("cloud", PointCloud{})
                            .apply<Artefact>();
  EXPECT_EQ(split(text_of(artefact, "ply"), "end_header").second, "");
}

}  // namespace
}  // namespace stope::exports
