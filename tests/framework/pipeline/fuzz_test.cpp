// Whatever bytes a pipeline file holds, checking it ends with sentences and never with a crash.
// Valid and broken pipelines are mutated in a fixed random order; run under ASan and UBSan this is
// a small fuzzer.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "checked.hpp"
#include "stope/random.hpp"

namespace stope {
namespace {

std::vector<std::string> seeds() {
  std::vector<std::filesystem::path> files;
  const auto folder = std::filesystem::path(STOPE_SOURCE_DIR) / "tests/pipelines/broken";
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.path().extension() == ".yaml") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  std::vector<std::string> texts;
  for (const auto& file : files) {
    std::ifstream in(file, std::ios::binary);
    std::ostringstream text;
    text << in.rdbuf();
    // Those that grow on purpose are slow, and slower when repeated.
    if (file.stem().string().find("bomb") == std::string::npos) texts.push_back(text.str());
  }
  return texts;
}

std::string mutated(std::string text, const std::vector<std::string>& all, Random& random) {
  static const std::vector<std::string> kTokens{
      "\"",   "'",     "{",     "}",     "[",   "]",  ": ",     "\n",    "\t", "  ",
      "- ",   "? ",    "&a ",   "*a ",   "!",   "<<", "${x",    "$$",    "#",  "|\n",
      ">",    "%",     "@",     "\x00",  "~",   ".",  "/",      "..",    "\r", "ü",
      "\xff", "---\n", "...\n", "stope", "use", "in", "params", "1e999", "-"};
  for (std::uint64_t edits = 1 + random.below(6); edits > 0; --edits) {
    const std::size_t at = random.below(text.size() + 1);
    const std::size_t length = random.below(12);
    switch (random.below(5)) {
      case 0:
        text.insert(at, kTokens[random.below(kTokens.size())]);
        break;
      case 1:
        text.erase(at, length);
        break;
      case 2:
        if (at < text.size()) text[at] = static_cast<char>(random.below(256));
        break;
      case 3:
        text.insert(at, text.substr(random.below(text.size() + 1), random.below(80)));
        break;
      default: {
        const std::string& other = all[random.below(all.size())];
        text.insert(at, other.substr(random.below(other.size() + 1), random.below(120)));
      }
    }
  }
  return text;
}

TEST(Fuzz, AnyBytesEndInSentences) {
  const std::vector<std::string> all = seeds();
  ASSERT_FALSE(all.empty());
  Random random(20240613);
  for (int round = 0; round < 6000; ++round) {
    const std::string text = mutated(all[random.below(all.size())], all, random);
    const Checked checked = check_text(text);
    EXPECT_TRUE(checked.plan || !checked.diagnostics.empty()) << text;
    for (const Diagnostic& diagnostic : checked.diagnostics) {
      EXPECT_EQ(diagnostic.code.size(), 4U);
      EXPECT_FALSE(diagnostic.sentence.empty());
    }
  }
}

TEST(Fuzz, OverridesToo) {
  const std::vector<std::string> all = seeds();
  Random random(7);
  const std::string text =
      "stope: 1\nvars: {a: 1}\nstages:\n  pit: {use: source/synthetic_pit}\n"
      "outputs: {t.tum: pit}\n";
  for (int round = 0; round < 3000; ++round) {
    const std::vector<std::string> bases{"pit.rings=16", "vars.a={b: [1, 2]}",
                                         "pit.use=source/kitti", "pit.in=pit.scans"};
    const Checked checked =
        check_text(text, {mutated(bases[random.below(bases.size())], all, random)});
    EXPECT_TRUE(checked.plan || !checked.diagnostics.empty());
  }
}

TEST(Fuzz, DeepAndWideThings) {
  const std::string deep(5000, '['), wide(200'000, 'a');
  for (const std::string& text :
       {deep, "a: " + deep, std::string(5000, '{'), "stope: 1\n" + wide + ": 1\n",
        "stope: 1\nstages: {" + wide + ": {use: " + wide + "}}\n", "\"" + wide,
        "stope: 1\nname: " + std::string(50'000, '$') + "\n", std::string(3000, '-') + "\n",
        "stope: 1\nstages:\n" + std::string(100'000, ' ') + "pit: 1\n"})
    EXPECT_FALSE(check_text(text).plan);
}

}  // namespace
}  // namespace stope
