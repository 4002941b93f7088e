#include "framework/pipeline/yaml_reader.hpp"

#include <gtest/gtest.h>

namespace stope {
namespace {

std::optional<LocatedNode> read(const std::string& text, Diagnostics& diagnostics) {
  return read_yaml(SourceText(text, "a.yaml", "/somewhere"), diagnostics);
}

LocatedNode read(const std::string& text) {
  Diagnostics diagnostics;
  auto root = read(text, diagnostics);
  EXPECT_TRUE(root) << text;
  EXPECT_FALSE(diagnostics.has_errors()) << to_text(diagnostics.sorted().at(0));
  return root.value_or(LocatedNode());
}

std::string at(const LocatedNode& node) { return to_text(node.place); }

TEST(YamlReader, KeysAndValuesKnowTheirPlaces) {
  const LocatedNode root = read("a: 1\nb:\n  c: [x, 'y']\n  \"d\": {e: f}\n");
  EXPECT_EQ(to_text(root.find("b")->place), "a.yaml:2:1");
  const LocatedNode& b = root.find("b")->value;
  EXPECT_EQ(at(b.find("c")->value), "a.yaml:3:6");
  EXPECT_EQ(at(b.find("c")->value.items.at(1)), "a.yaml:3:10");
  EXPECT_EQ(to_text(b.find("d")->place), "a.yaml:4:3");
  EXPECT_EQ(at(b.find("d")->value.find("e")->value), "a.yaml:4:12");
  EXPECT_EQ(b.find("c")->value.items.at(1).text, "y");
  EXPECT_EQ(b.folder, "/somewhere");
}

TEST(YamlReader, AnEmptyValueStandsBehindItsColon) {
  const LocatedNode root = read("a:\n\n# more\n'b c' :\nd: {e: , f: ~}\ng:\n  null\n");
  EXPECT_TRUE(root.find("a")->value.is_empty());
  EXPECT_EQ(at(root.find("a")->value), "a.yaml:1:3");
  EXPECT_EQ(at(root.find("b c")->value), "a.yaml:4:8");
  EXPECT_EQ(at(root.find("d")->value.find("e")->value), "a.yaml:5:7");
  EXPECT_EQ(at(root.find("d")->value.find("f")->value), "a.yaml:5:13");
  EXPECT_EQ(at(root.find("g")->value), "a.yaml:7:3");
}

TEST(YamlReader, AQuotedNullIsAText) {
  const LocatedNode root = read("a: \"null\"\nb: ''\n");
  EXPECT_EQ(root.find("a")->value.text, "null");
  EXPECT_TRUE(root.find("b")->value.is_scalar());
}

TEST(YamlReader, AnAliasRepeatsItsAnchor) {
  const LocatedNode root = read("a: &x {b: 1}\nc: *x\nd: &y 7\ne: *y\n");
  EXPECT_EQ(root.find("c")->value.find("b")->value.text, "1");
  EXPECT_EQ(root.find("e")->value.text, "7");
  EXPECT_EQ(at(root.find("e")->value), "a.yaml:4:4");
}

TEST(YamlReader, WindowsLineEndsAndByteOrderMarksDoNotShiftPlaces) {
  const LocatedNode root = read(
      "\xef\xbb\xbf"
      "a: 1\r\nb: 'x'\r\nc:\r\n");
  EXPECT_EQ(to_text(root.find("a")->place), "a.yaml:1:1");
  EXPECT_EQ(at(root.find("b")->value), "a.yaml:2:4");
  EXPECT_EQ(at(root.find("c")->value), "a.yaml:3:3");
}

TEST(YamlReader, ColumnsCountBytes) {
  const LocatedNode root = read("{über: 1, b: 2}\n");
  EXPECT_EQ(to_text(root.find("b")->place), "a.yaml:1:12");
}

TEST(YamlReader, AQuoteThatNeverClosesIsFoundWhereItOpens) {
  for (const char* text : {"a: \"b\nc: d\n", "a: 'it''s\n", "a: &x \"b\\\"\n", "'a: 1\n"}) {
    Diagnostics diagnostics;
    EXPECT_FALSE(read(text, diagnostics)) << text;
    ASSERT_EQ(diagnostics.sorted().size(), 1U) << text;
    EXPECT_EQ(diagnostics.sorted()[0].code, "P006") << text;
  }
}

TEST(YamlReader, TheFirstOfTwoEqualKeysIsKept) {
  Diagnostics diagnostics;
  const auto root = read("a: 1\na: 2\n", diagnostics);
  ASSERT_TRUE(root);
  EXPECT_EQ(root->find("a")->value.text, "1");
  EXPECT_EQ(diagnostics.sorted().at(0).code, "P007");
}

}  // namespace
}  // namespace stope
