#include "framework/pipeline/schema.hpp"

#include <gtest/gtest.h>

#include "fake_catalogue.hpp"

namespace stope {
namespace {

// The condition on stages that use this id.
nlohmann::json condition(const nlohmann::json& schema, const std::string& definition,
                         const std::string& id) {
  for (const auto& entry : schema["definitions"][definition]["allOf"])
    if (entry["if"]["properties"]["use"]["const"] == id) return entry["then"]["properties"];
  return nullptr;
}

TEST(Schema, KnowsEveryStageAndParameter) {
  const FakeCatalogue catalogue;
  const nlohmann::json schema = pipeline_schema(catalogue);
  for (const StageRecord& record : catalogue.stages()) {
    const bool exported = record.info.id.starts_with("export/");
    const auto stage = condition(schema, exported ? "export" : "stage", record.info.id);
    ASSERT_FALSE(stage.is_null()) << record.info.id;
    for (const ParameterInfo& parameter : record.info.parameters)
      EXPECT_TRUE(stage["params"]["properties"].contains(parameter.name)) << parameter.name;
    EXPECT_EQ(stage["params"]["additionalProperties"], false);
  }
}

TEST(Schema, CarriesLimitsAndDefaults) {
  const nlohmann::json schema = pipeline_schema(FakeCatalogue());
  const auto params = condition(schema, "stage", "map/voxels")["params"]["properties"];
  EXPECT_EQ(params["levels"]["anyOf"][0]["type"], "integer");
  EXPECT_EQ(params["levels"]["anyOf"][0]["maximum"], 8.0);
  EXPECT_EQ(params["speed"]["anyOf"][0]["exclusiveMinimum"], 0.0);
  EXPECT_EQ(params["speed"]["default"], 10.0);
  EXPECT_EQ(params["mode"]["anyOf"][0]["enum"].size(), 3U);
  EXPECT_EQ(params["weights"]["anyOf"][0]["maxItems"], 4);
  EXPECT_NE(params["speed"]["description"].get<std::string>().find("m/s"), std::string::npos);
}

TEST(Schema, RefusesUnknownKeysAtTheTop) {
  const nlohmann::json schema = pipeline_schema(FakeCatalogue());
  EXPECT_EQ(schema["additionalProperties"], false);
  for (const char* key : {"stope", "name", "include", "vars", "stages", "outputs"})
    EXPECT_TRUE(schema["properties"].contains(key)) << key;
}

}  // namespace
}  // namespace stope
