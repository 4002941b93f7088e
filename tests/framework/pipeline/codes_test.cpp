// The catalogue in docs/diagnostics.md, the codes in framework/pipeline/codes.hpp and the broken
// pipelines that show them must agree.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace stope {
namespace {

const std::filesystem::path kRoot = STOPE_SOURCE_DIR;

std::string read(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  EXPECT_TRUE(in) << file;
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

bool is_code(const std::string& text) {
  return text.size() == 4 && text[0] == 'P' &&
         text.find_first_not_of("0123456789", 1) == std::string::npos;
}

// All codes that stand between these two texts.
std::set<std::string> codes(const std::string& text, const std::string& before,
                            const std::string& after) {
  std::set<std::string> result;
  for (auto at = text.find(before); at != std::string::npos; at = text.find(before, at + 1)) {
    const std::string code = text.substr(at + before.size(), 4);
    if (is_code(code) && text.compare(at + before.size() + 4, after.size(), after) == 0)
      result.insert(code);
  }
  return result;
}

std::vector<std::string> lines(const std::string& text) {
  std::vector<std::string> result;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) result.push_back(line);
  return result;
}

std::string sources() {
  std::string all;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(kRoot / "framework"))
    if (entry.path().extension() == ".cpp" || entry.path().extension() == ".hpp")
      all += read(entry.path());
  return all;
}

TEST(Codes, OfTheSourceAreThoseOfTheCatalogue) {
  EXPECT_EQ(codes(sources(), "\"", "\""),
            codes(read(kRoot / "docs/diagnostics.md"), "\n### ", " "));
}

TEST(Codes, AreAllUsed) {
  const std::string all = sources(), mark = "constexpr const char* ";
  for (const std::string& line : lines(read(kRoot / "framework/pipeline/codes.hpp"))) {
    const auto at = line.find(mark);
    if (at == std::string::npos) continue;
    const auto begin = at + mark.size();
    const std::string name = line.substr(begin, line.find(' ', begin) - begin);
    EXPECT_NE(all.find("code::" + name), std::string::npos) << name;
  }
}

std::string golden_texts() {
  std::string golden;
  for (const auto& entry : std::filesystem::directory_iterator(kRoot / "tests/pipelines/broken"))
    if (entry.path().extension() == ".txt") golden += read(entry.path());
  return golden;
}

TEST(Codes, ExamplesInTheCatalogueAreReal) {
  const std::string golden = golden_texts();
  for (const std::string& line : lines(read(kRoot / "docs/diagnostics.md"))) {
    if (codes(line, "[", "]: ").empty() || line.starts_with("file:line")) continue;
    EXPECT_NE(golden.find(line + "\n"), std::string::npos) << line;
  }
}

TEST(Codes, AreShownByBrokenPipelines) {
  auto shown = codes(golden_texts(), "[", "]");
  shown.insert("P002");  // a file too large to keep here; files_test.cpp makes one
  EXPECT_EQ(shown, codes(sources(), "\"", "\""));
}

}  // namespace
}  // namespace stope
