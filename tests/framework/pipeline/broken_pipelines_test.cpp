// Every file in tests/pipelines/broken is wrong, and the text beside it is what a person must be
// told. Lines `# --set a.b=value` at a file's beginning are given as overrides. After changing a
// sentence on purpose, run with STOPE_WRITE_GOLDEN=1 and read the difference.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "checked.hpp"

namespace stope {
namespace {

const std::filesystem::path kFolder =
    std::filesystem::path(STOPE_SOURCE_DIR) / "tests/pipelines/broken";

std::string read(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

std::vector<std::string> broken_pipelines() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(kFolder))
    if (entry.path().extension() == ".yaml") names.push_back(entry.path().stem().string());
  std::sort(names.begin(), names.end());
  return names;
}

std::vector<std::string> overrides_of(const std::filesystem::path& file) {
  const std::string kMark = "# --set ";
  std::vector<std::string> overrides;
  std::ifstream in(file);
  for (std::string line; std::getline(in, line) && line.starts_with(kMark);)
    overrides.push_back(line.substr(kMark.size()));
  return overrides;
}

// The checkout may lie anywhere.
std::string without_folder(std::string text) {
  const std::string folder = kFolder.string();
  for (auto at = text.find(folder); at != std::string::npos; at = text.find(folder))
    text.replace(at, folder.size(), "HERE");
  return text;
}

class BrokenPipeline : public testing::TestWithParam<std::string> {};

TEST_P(BrokenPipeline, IsExplained) {
  unsetenv("STOPE_NOWHERE");
  const auto before = std::filesystem::current_path();
  std::filesystem::current_path(kFolder);
  const std::string file = GetParam() + ".yaml";
  const Checked checked = check_file(file, overrides_of(file));
  std::filesystem::current_path(before);

  const std::filesystem::path golden = kFolder / (GetParam() + ".txt");
  const std::string text = without_folder(checked.text);
  if (std::getenv("STOPE_WRITE_GOLDEN")) std::ofstream(golden, std::ios::binary) << text;
  EXPECT_FALSE(checked.plan);
  EXPECT_EQ(text, read(golden));
}

INSTANTIATE_TEST_SUITE_P(All, BrokenPipeline, testing::ValuesIn(broken_pipelines()),
                         [](const auto& info) { return info.param; });

TEST(BrokenPipelines, AreMany) { EXPECT_GE(broken_pipelines().size(), 60U); }

}  // namespace
}  // namespace stope
