// The catalogue in docs/diagnostics.md, the codes in framework/pipeline/codes.hpp and the broken
// pipelines that show them must agree.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>

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

std::set<std::string> matches(const std::string& text, const std::string& pattern) {
  const std::regex regex(pattern);
  std::set<std::string> result;
  for (std::sregex_iterator i(text.begin(), text.end(), regex), end; i != end; ++i)
    result.insert((*i)[1]);
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
  EXPECT_EQ(matches(sources(), "\"(P[0-9]{3})\""),
            matches(read(kRoot / "docs/diagnostics.md"), "\n### (P[0-9]{3}) "));
}

TEST(Codes, AreAllUsed) {
  const std::string all = sources();
  const auto names = matches(read(kRoot / "framework/pipeline/codes.hpp"), "char\\* (k[A-Za-z]+)");
  for (const std::string& name : names)
    EXPECT_NE(all.find("code::" + name), std::string::npos) << name;
}

std::string golden_texts() {
  std::string golden;
  for (const auto& entry : std::filesystem::directory_iterator(kRoot / "tests/pipelines/broken"))
    if (entry.path().extension() == ".txt") golden += read(entry.path());
  return golden;
}

TEST(Codes, ExamplesInTheCatalogueAreReal) {
  const std::string golden = golden_texts();
  const std::string pattern = "\n([^ \n]+: (error|warning|note)\\[P[0-9]{3}\\][^\n]*)";
  for (const std::string& line : matches(read(kRoot / "docs/diagnostics.md"), pattern)) {
    if (line.starts_with("file:line")) continue;
    EXPECT_NE(golden.find(line + "\n"), std::string::npos) << line;
  }
}

TEST(Codes, AreShownByBrokenPipelines) {
  auto shown = matches(golden_texts(), "\\[(P[0-9]{3})\\]");
  shown.insert("P002");  // a file too large to keep here; files_test.cpp makes one
  EXPECT_EQ(shown, matches(sources(), "\"(P[0-9]{3})\""));
}

}  // namespace
}  // namespace stope
