#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "tests/plugins/export/export_samples.hpp"
#include "tests/plugins/stage_harness.hpp"

extern "C" const stope::StageEntry* stope_stage_MeasuresJson();

namespace stope::exports {
namespace {

TEST(MeasuresJson, ReadsBackWhateverTheTexts) {
  const Measures measures{
      {"ate_rmse", "odd \"name\"\\\n"}, {1.0 / 3, std::nan("")}, {"m", ""}, {"", "no truth"}};
  const auto json =
      nlohmann::json::parse(text_of(stope::testing::StageHarness(stope_stage_MeasuresJson())
                                        .input("measures", measures)
                                        .apply<Artefact>(),
                                    "json"));
  ASSERT_EQ(json["measures"].size(), 2U);
  EXPECT_EQ(json["measures"][0]["value"].get<double>(), 1.0 / 3);
  EXPECT_EQ(json["measures"][0]["unit"], "m");
  EXPECT_EQ(json["measures"][1]["name"], measures.names[1]);
  EXPECT_TRUE(json["measures"][1]["value"].is_null());
  EXPECT_EQ(json["measures"][1]["note"], "no truth");
}

}  // namespace
}  // namespace stope::exports
