#include "framework/report/output_name.hpp"

#include <gtest/gtest.h>

#include "stope/error.hpp"

namespace stope::report {
namespace {

TEST(OutputName, MayBeAFileOrAFileInAFolder) {
  for (const char* name : {"roads.geojson", "maps/prior.yaml", "a", "höhe über.png", "a..b.png"})
    EXPECT_NO_THROW(check_output_name(name)) << name;
}

TEST(OutputName, CannotLeaveTheFolder) {
  for (const char* name :
       {"", "..", "../roads.geojson", "maps/../../roads.geojson", "/tmp/roads.geojson", "a//b",
        "maps/", "./roads.geojson", ".hidden", "maps/.git/config", "..\\roads", "a\nb", "a\x7f"})
    EXPECT_THROW(check_output_name(name), Error) << name;
  EXPECT_THROW(check_output_name(std::string("a\0b", 3)), Error);
  EXPECT_THROW(check_output_name(std::string(300, 'a')), Error);
}

TEST(OutputName, TheSentenceQuotesTheNameWithoutControlCharacters) {
  try {
    check_output_name("a\x1b[2Jb");
    FAIL() << "the name was accepted";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("'a?[2Jb'"), std::string::npos) << error.what();
  }
}

TEST(OutputName, ExtensionsOfExportsCannotMoveTheFile) {
  EXPECT_NO_THROW(check_extension("pgm"));
  EXPECT_NO_THROW(check_extension("tar.gz"));
  for (const char* extension : {"", "../x", "a/b", ".", ".x", "a\\b", "a\n"})
    EXPECT_THROW(check_extension(extension), Error) << extension;
}

TEST(OutputName, TheStemIsTheNameWithoutItsExtension) {
  EXPECT_EQ(output_stem("map.yaml", "yaml"), "map");
  EXPECT_EQ(output_stem("maps/a.tar.gz", "tar.gz"), "maps/a");
  EXPECT_EQ(output_stem("map.yml", "yaml"), "map");
  EXPECT_EQ(output_stem("v1.2/map", "yaml"), "v1.2/map");
  EXPECT_EQ(item_stem(42), "000042");
  EXPECT_EQ(item_stem(12345678), "12345678");
}

}  // namespace
}  // namespace stope::report
