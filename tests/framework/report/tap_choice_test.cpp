#include "framework/report/tap_choice.hpp"

#include <gtest/gtest.h>

#include "framework/report/draw/png.hpp"
#include "framework/report/payload_tap.hpp"
#include "framework/report/port_name.hpp"
#include "stope/payloads.hpp"
#include "tests/framework/report/made_run.hpp"

namespace stope::report {
namespace {

std::vector<std::string> names_of(const Plan& plan) {
  std::vector<std::string> names;
  for (const TapChoice& tap : choose_taps(plan))
    names.push_back(port_name(plan, tap.source) + (tap.digest ? " digest" : "") +
                    (tap.draw ? " drawn" : ""));
  return names;
}

TEST(TapChoice, LeavesPortsAloneThatNobodyReads) {
  made::PlanMaker maker("taps");
  const std::size_t scans = maker.stage("scans", "source/any", {},
                                        {{"scans", std::string(LidarScan::kType), true},
                                         {"trajectory", std::string(Trajectory::kType)},
                                         {"imu", std::string(ImuSample::kType), true}});
  const std::size_t cloud = maker.stage("cloud", "map/any", {{"scans", {scans, 0}}},
                                        {{"cloud", std::string(PointCloud::kType)}});
  maker.output("cloud.pcd", {cloud, 0});
  EXPECT_EQ(names_of(maker.plan),
            (std::vector<std::string>{"scans.scans drawn", "cloud.cloud digest drawn"}));
}

TEST(TapChoice, ReadsAStageThatHasNoOtherReaderAndAllMeasures) {
  made::PlanMaker maker("taps");
  const std::size_t grid =
      maker.stage("grid", "map_source/any", {}, {{"grid", std::string(OccupancyGrid::kType)}});
  maker.stage("judge", "metric/any", {{"grid", {grid, 0}}},
              {{"measures", std::string(Measures::kType)}});
  maker.stage("last", "rasterizer/any", {{"grid", {grid, 0}}},
              {{"heights", std::string(ElevationGrid::kType)}});
  EXPECT_EQ(
      names_of(maker.plan),
      (std::vector<std::string>{"grid.grid drawn", "judge.measures drawn", "last.heights drawn"}));
}

// Counts how often it is brought into memory.
class CountingPayload final : public Payload {
 public:
  explicit CountingPayload(int& pins) : pins_(pins) {}
  const PayloadType& type() const noexcept override { return payload_type<Measures>(); }
  std::shared_ptr<const void> pin() override {
    ++pins_;
    return std::make_shared<const Measures>();
  }

 private:
  int& pins_;
};

TEST(PayloadTap, TouchesOnlyTheFirstAndLastItemOfAStream) {
  std::vector<int> pins(100, 0);
  PayloadTap tap({0, 0}, true, false, [](const void*) { return Sketch{}; });
  for (std::size_t i = 0; i < pins.size(); ++i)
    tap.take({static_cast<Stamp>(i), i, std::make_shared<CountingPayload>(pins[i])});
  tap.finish();
  EXPECT_EQ(pins.front(), 1);
  EXPECT_EQ(pins.back(), 1);
  EXPECT_EQ(std::count(pins.begin(), pins.end(), 0), 98);
  ASSERT_EQ(tap.sketches().size(), 2U);
  EXPECT_EQ(tap.sketches()[0].index, 0U);
  EXPECT_EQ(tap.sketches()[1].index, 99U);
}

TEST(PayloadTap, PacksThePictureItDraws) {
  int pins = 0;
  const auto draw = [](const void*) {
    Sketch sketch;
    Raster raster;
    raster.picture = {2, 1, {{1, 2, 3, 255}, {4, 5, 6, 255}}};
    sketch.raster = raster;
    return sketch;
  };
  PayloadTap tap({0, 0}, false, false, draw);
  tap.take({0, 0, std::make_shared<CountingPayload>(pins)});
  tap.finish();
  const Raster& raster = tap.sketches().at(0).raster.value();
  EXPECT_EQ(raster.png, encode_png({2, 1, {{1, 2, 3, 255}, {4, 5, 6, 255}}}));
  EXPECT_TRUE(raster.picture.pixels.empty());
  EXPECT_EQ(raster.picture.width, 2) << "the page asks how large it is";
}

}  // namespace
}  // namespace stope::report
