#include <gtest/gtest.h>

#include <stope/testing/stage_harness.hpp>

#include "sector.hpp"

extern "C" const stope::StageEntry* stope_stage_Census();

namespace acme {
namespace {

TEST(Census, CountsWhatTheSectorsHold) {
  stope::testing::MemoryInput<Sector> sectors;
  sectors.add(1, {7, "north", {}});
  sectors.add(2, {5, "south", {}});
  stope::testing::MemoryOutput<stope::Measures> measures;
  stope::testing::StageHarness(stope_stage_Census())
      .connect_input("sectors", sectors)
      .connect_output("measures", measures)
      .run();
  ASSERT_EQ(measures.items.size(), 1U);
  EXPECT_EQ(measures.items[0].value->values, (std::vector<double>{2, 12}));
}

TEST(Census, SaysWhatToDoWithoutSectors) {
  EXPECT_NE(stope::testing::error_of([] {
              stope::testing::StageHarness(stope_stage_Census()).run();
            }).find("raise 'count'"),
            std::string::npos);
}

}  // namespace
}  // namespace acme
