// The rules that keep the house in order, checked on its own sources: which part may include which,
// what public headers may pull in, and what no CMake file or header may do.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;

const fs::path kRoot = STOPE_SOURCE_DIR;

std::vector<fs::path> files_under(const fs::path& folder, const std::set<std::string>& extensions) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(kRoot / folder)) {
    if (entry.is_regular_file() && extensions.contains(entry.path().extension().string())) {
      files.push_back(entry.path());
    }
  }
  return files;
}

std::vector<std::string> lines_of(const fs::path& file) {
  std::ifstream stream(file);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

// What a file includes, without the brackets or quotes.
std::vector<std::string> includes_of(const fs::path& file) {
  static const std::regex kInclude(R"(^\s*#\s*include\s*[<"]([^>"]+)[>"])");
  std::vector<std::string> includes;
  for (const std::string& line : lines_of(file)) {
    std::smatch match;
    if (std::regex_search(line, match, kInclude)) includes.push_back(match[1]);
  }
  return includes;
}

TEST(HouseRules, PluginsSeeTheSdkAndTheirOwnFolderOnly) {
  for (const auto& file : files_under("plugins", {".hpp", ".cpp"})) {
    const std::string family = fs::relative(file, kRoot / "plugins").begin()->string();
    for (const std::string& include : includes_of(file)) {
      EXPECT_FALSE(include.starts_with("framework/")) << file << " includes " << include;
      if (include.starts_with("plugins/")) {
        EXPECT_TRUE(include.starts_with("plugins/" + family + "/"))
            << file << " includes " << include;
      }
    }
  }
}

TEST(HouseRules, TheFrameworkNeverIncludesAPlugin) {
  for (const auto& file : files_under("framework", {".hpp", ".cpp"})) {
    for (const std::string& include : includes_of(file)) {
      EXPECT_FALSE(include.starts_with("plugins/")) << file << " includes " << include;
    }
  }
}

TEST(HouseRules, PublicHeadersNeedTheStandardLibraryAndEigenAlone) {
  for (const auto& file : files_under("sdk", {".hpp", ".cpp"})) {
    const bool header = file.string().find("/include/") != std::string::npos;
    for (const std::string& include : includes_of(file)) {
      EXPECT_FALSE(include.starts_with("framework/") || include.starts_with("plugins/"))
          << file << " includes " << include;
      const bool standard =
          include.find('/') == std::string::npos && include.find(".hpp") == std::string::npos;
      const bool allowed =
          standard || include.starts_with("stope/") || include.starts_with("Eigen/");
      EXPECT_TRUE(!header || allowed) << file << " includes " << include;
    }
  }
}

TEST(HouseRules, OnlyTwoMacrosExist) {
  static const std::regex kDefine(R"(^\s*#\s*define\s+(\w+))");
  const std::set<std::string> allowed{"STOPE_STAGE", "STOPE_PLUGIN", "STOPE_API"};
  for (const char* folder : {"sdk", "framework", "plugins"}) {
    for (const auto& file : files_under(folder, {".hpp", ".cpp"})) {
      for (const std::string& line : lines_of(file)) {
        std::smatch match;
        if (!std::regex_search(line, match, kDefine)) continue;
        EXPECT_TRUE(allowed.contains(match[1])) << file << ": " << line;
      }
    }
  }
}

// Two types of one name in one namespace make one program of two that do not fit: the linker keeps
// the functions of either, and says nothing. There were two stope::topology::Link.
TEST(HouseRules, NoTwoHeadersDefineTypesOfTheSameName) {
  static const std::regex kNamespace(R"(^namespace ([\w:]+) \{)");
  static const std::regex kType(R"(^(?:struct|class|enum class) (?:STOPE_API )?(\w+)( .*)?\{)");
  std::map<std::string, fs::path> defined;
  for (const char* folder : {"sdk", "framework", "plugins"}) {
    for (const auto& file : files_under(folder, {".hpp"})) {
      std::string space;
      for (const std::string& line : lines_of(file)) {
        std::smatch match;
        if (std::regex_search(line, match, kNamespace)) space = match[1];
        if (!std::regex_search(line, match, kType)) continue;
        const auto [known, is_new] = defined.emplace(space + "::" + match[1].str(), file);
        EXPECT_TRUE(is_new) << known->first << " is defined in " << known->second << " and in "
                            << file;
      }
    }
  }
  EXPECT_GT(defined.size(), 300U);
}

TEST(HouseRules, CMakeListsNameTheirFiles) {
  for (const char* folder : {"sdk", "framework", "plugins", "tests"}) {
    for (const auto& file : files_under(folder, {".txt", ".cmake"})) {
      for (const std::string& line : lines_of(file)) {
        EXPECT_EQ(line.find("file(GLOB"), std::string::npos) << file;
        EXPECT_EQ(line.find("set(CMAKE_CXX_FLAGS"), std::string::npos) << file;
        EXPECT_EQ(line.find("add_compile_options("), std::string::npos) << file;
        EXPECT_EQ(line.find("FetchContent"), std::string::npos) << file;
        EXPECT_EQ(line.find("march=native"), std::string::npos) << file;
      }
    }
  }
}

TEST(HouseRules, NoMergeWasLeftHalfDone) {
  const std::set<std::string> kAll{"", ".cpp", ".hpp", ".txt", ".cmake", ".md", ".yaml"};
  for (const char* folder :
       {"sdk", "framework", "plugins", "tests", "tools", "docs", "pipelines"}) {
    for (const auto& file : files_under(folder, kAll)) {
      for (const std::string& line : lines_of(file))
        EXPECT_FALSE(line.starts_with("<<<<<<< ") || line.starts_with(">>>>>>> "))
            << file << ": " << line;
    }
  }
}

}  // namespace
