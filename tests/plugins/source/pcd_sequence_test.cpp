#include <gmock/gmock.h>

#include <cstdint>
#include <cstring>
#include <string>

#include "plugins/source/recording/pcd_scan.hpp"
#include "stope/payloads.hpp"
#include "stope/random.hpp"
#include "tests/plugins/source/stage_harness.hpp"
#include "tests/plugins/source/test_folder.hpp"

extern "C" const stope::StageEntry* stope_stage_PcdSequence();

namespace stope::source {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

template <class T>
std::string bytes_of(T value) {
  return {reinterpret_cast<const char*>(&value), sizeof(T)};
}

const std::string kAscii =
    "# .PCD v0.7\nVERSION 0.7\nFIELDS x y z intensity ring t\nSIZE 4 4 4 1 2 4\nTYPE F F F U U U\n"
    "COUNT 1 1 1 1 1 1\nWIDTH 3\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS 3\nDATA ascii\n"
    "1 2 3 200 0 1000\n4 5.5 -6 7 15 3000\nnan nan nan 0 0 2000\n";

/// Two points with a field of three numbers that no scan needs, in the order of the head.
const std::string kBinaryHead =
    "FIELDS x normal y z time\nSIZE 8 4 4 4 8\nTYPE F F F F F\nCOUNT 1 3 1 1 1\nWIDTH 2\n"
    "HEIGHT 1\nPOINTS 2\nDATA ";

std::string binary_file() {
  std::string bytes = kBinaryHead + "binary\n";
  for (int i = 0; i < 2; ++i) {
    bytes += bytes_of(1.5 + i);
    for (int k = 0; k < 3; ++k) bytes += bytes_of(-1.0f);
    bytes += bytes_of(10.0f + static_cast<float>(i)) + bytes_of(20.0f + static_cast<float>(i));
    bytes += bytes_of(100.0 + 0.25 * i);
  }
  return bytes;
}

/// The same points field by field, packed by LZF as literals only: a byte n - 1, then n bytes.
std::string compressed_file() {
  std::string full = bytes_of(1.5) + bytes_of(2.5);
  for (int k = 0; k < 6; ++k) full += bytes_of(-1.0f);
  full += bytes_of(10.0f) + bytes_of(11.0f) + bytes_of(20.0f) + bytes_of(21.0f);
  full += bytes_of(100.0) + bytes_of(100.25);
  std::string packed;
  for (std::size_t at = 0; at < full.size(); at += 32) {
    const std::string part = full.substr(at, 32);
    packed += static_cast<char>(part.size() - 1) + part;
  }
  return kBinaryHead + "binary_compressed\n" + bytes_of(static_cast<std::uint32_t>(packed.size())) +
         bytes_of(static_cast<std::uint32_t>(full.size())) + packed;
}

void expect_two_points(const LidarScan& scan) {
  EXPECT_THAT(scan.points, ElementsAre(Point3f{1.5f, 10, 20}, Point3f{2.5f, 11, 21}));
  EXPECT_THAT(scan.time_offset, ElementsAre(-250'000'000, 0));
  EXPECT_TRUE(scan.intensity.empty());
  EXPECT_TRUE(scan.ring.empty());
}

std::string refusal(std::string_view bytes) {
  try {
    parse_pcd_scan(bytes);
  } catch (const Error& error) {
    return error.what();
  }
  return "accepted";
}

TEST(PcdScan, ReadsAscii) {
  const ReadScan read = parse_pcd_scan(kAscii);
  EXPECT_THAT(read.scan.points, ElementsAre(Point3f{1, 2, 3}, Point3f{4, 5.5f, -6}));
  EXPECT_THAT(read.scan.intensity, ElementsAre(200, 7));
  EXPECT_THAT(read.scan.ring, ElementsAre(0, 15));
  EXPECT_THAT(read.scan.time_offset, ElementsAre(-2000, 0));  // whole numbers are nanoseconds
  EXPECT_EQ(read.dropped, 1u);
}

TEST(PcdScan, ReadsBinary) { expect_two_points(parse_pcd_scan(binary_file()).scan); }

TEST(PcdScan, ReadsBinaryCompressed) { expect_two_points(parse_pcd_scan(compressed_file()).scan); }

TEST(PcdScan, SaysWhatIsWrong) {
  EXPECT_THAT(refusal(""), HasSubstr("no DATA line"));
  EXPECT_THAT(refusal(kAscii.substr(0, kAscii.size() - 21)), HasSubstr("truncated"));
  const std::string binary = binary_file(), packed = compressed_file();
  EXPECT_THAT(refusal(binary.substr(0, binary.size() - 1)), HasSubstr("truncated"));
  EXPECT_THAT(refusal(packed.substr(0, packed.size() - 1)), HasSubstr("truncated"));
  EXPECT_THAT(refusal("FIELDS x y\nSIZE 4 4\nTYPE F F\nWIDTH 1\nDATA ascii\n1 2\n"),
              HasSubstr("no field z"));
  EXPECT_THAT(refusal("FIELDS x y z\nSIZE 4 4\nTYPE F F F\nWIDTH 1\nDATA ascii\n"),
              HasSubstr("SIZE line has 2 entries for 3 fields"));
  EXPECT_THAT(refusal("FIELDS x y z\nSIZE 4 4 3\nTYPE F F F\nWIDTH 1\nDATA ascii\n"),
              HasSubstr("field z is of type F with 3 bytes"));
  EXPECT_THAT(refusal("FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH 0\nDATA binary\n"),
              HasSubstr("no points"));
  EXPECT_THAT(
      refusal("FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH 2000000000\nDATA ascii\n1 2 3\n"),
      HasSubstr("more than its 6 bytes can hold"));
  EXPECT_THAT(refusal("FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH 1\nDATA ascii\nnan 1 2\n"),
              HasSubstr("none of its 1 points is finite"));
}

TEST(PcdScan, ReadsAnyBytesWithoutHarm) {
  Random random(3);
  for (const std::string& good : {kAscii, binary_file(), compressed_file()}) {
    for (int round = 0; round < 4000; ++round) {
      std::string bytes = good;
      for (auto changes = random.below(4) + 1; changes > 0; --changes)
        bytes[random.below(bytes.size())] = static_cast<char>(random.below(256));
      if (random.below(3) == 0) bytes.resize(random.below(bytes.size()));
      try {
        const ReadScan read = parse_pcd_scan(bytes);
        EXPECT_FALSE(read.scan.points.empty());
      } catch (const Error& error) {
        EXPECT_STRNE(error.what(), "");
      }
    }
  }
}

TEST(PcdSequence, ReadsAFolderInTheOrderOfNumbers) {
  const TestFolder folder;
  const auto file = [](int x) {
    return "FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH 1\nDATA ascii\n" + std::to_string(x) +
           " 0 0\n";
  };
  for (const int i : {10, 2, 1}) folder.write("scan" + std::to_string(i) + ".pcd", file(i));
  StageHarness harness(stope_stage_PcdSequence());
  testing::MemoryOutput<LidarScan> scans;
  testing::MemoryOutput<Trajectory> trajectory;
  harness.set("scans", folder.path().string());
  harness.set(
      "trajectory",
      folder.write("path.txt", "1 0 0 0 0 0 0 1\n2.5 1 0 0 0 0 0 1\n3 2 0 0 0 0 1 0\n").string());
  const Outcome outcome = harness.keep("scans", scans).keep("trajectory", trajectory).run();
  ASSERT_TRUE(outcome) << outcome.sentence;
  ASSERT_EQ(scans.items.size(), 3u);
  EXPECT_EQ(scans.items[0].value->points[0].x, 1);
  EXPECT_EQ(scans.items[1].value->points[0].x, 2);
  EXPECT_EQ(scans.items[2].value->points[0].x, 10);
  EXPECT_EQ(scans.items[1].stamp, 2'500'000'000);
}

TEST(PcdSequence, NamesTheFileThatIsDamaged) {
  const TestFolder folder;
  folder.write("a.pcd", "this is no point cloud\n");
  StageHarness harness(stope_stage_PcdSequence());
  testing::MemoryOutput<LidarScan> scans;
  harness.set("scans", folder.path().string());
  const Outcome outcome = harness.keep("scans", scans).run();
  EXPECT_EQ(outcome.kind, Outcome::Kind::kFailed);
  EXPECT_THAT(outcome.sentence, HasSubstr("a.pcd: there is no DATA line"));
}

TEST(PcdSequence, ReadsRealScans) {
  const auto recording = real_data("vlp16_loop/data_set_reduced");
  if (!std::filesystem::exists(recording))
    GTEST_SKIP() << "there is no " << recording << ": set STOPE_DATA to run this test";
  StageHarness harness(stope_stage_PcdSequence());
  testing::MemoryOutput<LidarScan> scans;
  harness.set("scans", recording.string());
  const Outcome outcome = harness.keep("scans", scans).run();
  ASSERT_TRUE(outcome) << outcome.sentence;
  ASSERT_EQ(scans.items.size(), 323u);
  EXPECT_EQ(scans.items[0].value->points.size(), 411u);  // scan0.pcd, by its head
  EXPECT_EQ(scans.items[0].value->ring.size(), 411u);
}

TEST(PcdScan, ReadsRealCompressedAndWideFiles) {
  const auto terrain = real_data("isprs_terrain/samp11-utm.pcd");
  if (!std::filesystem::exists(terrain))
    GTEST_SKIP() << "there is no " << terrain << ": set STOPE_DATA to run this test";
  EXPECT_EQ(read_pcd_scan(terrain).scan.points.size(), 38'010u);  // by its head
  const ReadScan wide = read_pcd_scan(real_data("format_samples/autzen-utm.pcd"));
  EXPECT_EQ(wide.scan.points.size(), 1065u);
  EXPECT_EQ(wide.scan.intensity.size(), 1065u);
}

}  // namespace
}  // namespace stope::source
