#include "plugins/map_source/cell_rule.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace stope::map_source {
namespace {

// What nav2's map_io makes of a grey 8-bit pixel, in its own units: percent, or -1 for unknown.
int nav2_percent(int pixel, MapMode mode, bool negate, double occupied_thresh, double free_thresh) {
  const double shade = pixel / 255.0;
  const double occupied = negate ? shade : 1.0 - shade;
  switch (mode) {
    case MapMode::kTrinary:
      return occupied_thresh < occupied ? 100 : occupied < free_thresh ? 0 : -1;
    case MapMode::kScale:
      if (occupied_thresh < occupied) return 100;
      if (occupied < free_thresh) return 0;
      return static_cast<int>(
          std::rint((occupied - free_thresh) / (occupied_thresh - free_thresh) * 100));
    case MapMode::kRaw:
      return pixel <= 100 ? pixel : -1;
  }
  return -2;
}

TEST(CellRule, AgreesWithNav2OnEveryPixelModeAndThreshold) {
  for (const MapMode mode : {MapMode::kTrinary, MapMode::kScale, MapMode::kRaw}) {
    for (const bool negate : {false, true}) {
      for (const auto& [occupied, free] : {std::pair{0.65, 0.196}, {0.9, 0.1}, {0.5, 0.25}}) {
        const CellRule rule{mode, negate, occupied, free};
        for (int pixel = 0; pixel <= 255; ++pixel) {
          const int percent = nav2_percent(pixel, mode, negate, occupied, free);
          const int cell = rule.cell(pixel / 255.0, false);
          if (percent < 0) {
            EXPECT_EQ(cell, 255) << pixel;
          } else {
            ASSERT_NE(cell, 255) << pixel;
            EXPECT_NEAR(cell / 254.0, percent / 100.0, 0.005 + 0.5 / 254) << pixel;
          }
        }
      }
    }
  }
}

TEST(CellRule, TheWellKnownValuesOfASavedMap) {
  const CellRule rule;
  EXPECT_EQ(rule.cell(254 / 255.0, false), 0);
  EXPECT_EQ(rule.cell(0 / 255.0, false), 254);
  EXPECT_EQ(rule.cell(205 / 255.0, false), 255);
}

TEST(CellRule, TransparentIsUnknownInScaleModeOnly) {
  EXPECT_EQ((CellRule{MapMode::kScale, false, 0.65, 0.196}).cell(1.0, true), 255);
  EXPECT_EQ((CellRule{MapMode::kTrinary, false, 0.65, 0.196}).cell(1.0, true), 0);
}

}  // namespace
}  // namespace stope::map_source
