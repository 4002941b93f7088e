// Docs rot unless they are run: pipelines in them are checked, code is compiled, commands are
// checked, the stage reference is compared with what the stages declare, and links must lead
// somewhere. A snippet that cannot be tested says why in a comment
// `<!-- not run: … -->` on the line before it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <regex>
#include <sstream>

#include "../pipelines/stope_process.hpp"

namespace stope::testing {
namespace {

namespace fs = std::filesystem;

struct Snippet {
  fs::path file;
  int line = 0;
  std::string language, text;
  std::string where() const { return file.string() + ":" + std::to_string(line); }
};

std::vector<fs::path> pages() {
  std::vector<fs::path> list{shipped("README.md")};
  for (const auto& entry : fs::directory_iterator(shipped("docs"))) {
    if (entry.path().extension() == ".md") list.push_back(entry.path());
  }
  std::sort(list.begin(), list.end());
  return list;
}

std::vector<Snippet> snippets(const std::string& language) {
  std::vector<Snippet> list;
  for (const fs::path& page : pages()) {
    std::istringstream text(read_file(page));
    std::string line, before;
    Snippet open;
    bool inside = false;
    for (int number = 1; std::getline(text, line); ++number) {
      if (!inside && line.starts_with("```") && line.size() > 3) {
        open = {page, number, line.substr(3), ""};
        inside = true;
        if (before.find("not run:") != std::string::npos) open.language = "skipped";
      } else if (inside && line.starts_with("```")) {
        inside = false;
        if (open.language == language) list.push_back(open);
      } else if (inside) {
        open.text += line + "\n";
      } else if (!line.empty()) {
        before = line;
      }
    }
  }
  return list;
}

TEST(Docs, PipelinesInThemAreRight) {
  const TemporaryFolder folder;
  const auto data = data_folder();
  int count = 0;
  for (const Snippet& snippet : snippets("yaml")) {
    if (!snippet.text.starts_with("stope: 1")) continue;
    if (data.empty() && snippet.text.find("STOPE_DATA") != std::string::npos) continue;
    const fs::path copy = folder.path() / ("snippet" + std::to_string(count++) + ".yaml");
    write_file(copy, snippet.text);
    const auto result = stope({"check", copy.string()}, {{"STOPE_DATA", data.string()}});
    EXPECT_EQ(result.exit_code, 0) << snippet.where() << "\n" << result.err;
  }
}

TEST(Docs, CodeInThemCompiles) {
  const TemporaryFolder folder;
  for (const Snippet& snippet : snippets("cpp")) {
    if (snippet.text.find("#include") == std::string::npos) continue;
    const fs::path file = folder.path() / "snippet.cpp";
    write_file(file, snippet.text);
    const std::string command =
        std::string(STOPE_COMPILER) + " -std=c++20 -fsyntax-only -Wall -Wextra -Werror -I" +
        shipped("sdk/include") + " -I" + shipped("sdk/testing/include") +
        " -isystem " STOPE_EIGEN " " + file.string() + " 2> " + (folder.path() / "log").string();
    EXPECT_EQ(std::system(command.c_str()), 0) << snippet.where() << "\n"
                                               << read_file(folder.path() / "log");
  }
}

TEST(Docs, CommandsInThemAreRight) {
  static const std::regex kRun(R"(^build/bin/stope run (\S+)(.*)$)");
  for (const Snippet& snippet : snippets("sh")) {
    std::istringstream text(snippet.text);
    for (std::string line; std::getline(text, line);) {
      std::smatch match;
      if (!std::regex_match(line, match, kRun) || line.find("mine.yaml") != std::string::npos)
        continue;
      std::vector<std::string> arguments{"check", shipped(match[1])};
      std::istringstream words(match[2].str());
      for (std::string word; words >> word;) {
        if (word == "--out" || word == "--threads" || word == "--memory" || word == "--seed" ||
            word == "--keep" || word == "--cache" || word == "--cache-limit") {
          words >> word;
        } else if (word == "--why" || word == "--resume" || word == "--no-cache") {
          continue;
        } else {
          arguments.push_back(word);
        }
      }
      const auto result = stope(arguments, {{"STOPE_DATA", data_folder().string()}});
      EXPECT_EQ(result.exit_code, 0) << snippet.where() << ": " << line << "\n" << result.err;
    }
  }
}

TEST(Docs, TheStageReferenceIsWhatTheStagesDeclare) {
  const auto result = stope({"inspect", "--markdown"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const std::string page = read_file(shipped("docs/stages.md"));
  EXPECT_NE(page.find(result.out), std::string::npos)
      << "docs/stages.md is out of date; write it anew with tools/reference.";
}

TEST(Docs, LinksLeadSomewhere) {
  static const std::regex kLink(R"(\]\(([^)#:]+)(#[^)]*)?\))");
  for (const fs::path& page : pages()) {
    const std::string text = read_file(page);
    for (auto link = std::sregex_iterator(text.begin(), text.end(), kLink);
         link != std::sregex_iterator(); ++link) {
      EXPECT_TRUE(fs::exists(page.parent_path() / (*link)[1].str()))
          << page << " links to " << (*link)[1];
    }
  }
}

}  // namespace
}  // namespace stope::testing
