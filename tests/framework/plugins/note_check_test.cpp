#include "framework/plugins/note_check.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <set>

#include "framework/plugins/plugin_file.hpp"

namespace stope {
namespace {

/// What is said of a note like the host's own but for one change.
std::string complaint(const std::function<void(AbiNote&)>& change) {
  AbiNote note = make_abi_note("acme", "1.0.0");
  change(note);
  try {
    check_note({note, true, ""});
  } catch (const PluginRefused& refused) {
    return refused.what();
  }
  return "";
}

TEST(NoteCheck, AcceptsItsOwnKind) {
  EXPECT_EQ(complaint([](AbiNote&) {}), "");
}

TEST(NoteCheck, EachMismatchHasASentenceOfItsOwn) {
  const std::vector<std::pair<std::function<void(AbiNote&)>, std::string>> cases{
      {[](AbiNote& n) { n.epoch = 0; }, "ABI epoch 0"},
      {[](AbiNote& n) { n.compiler_family = 0; }, "g++ 12 or newer or clang++ 14 or newer"},
      {[](AbiNote& n) { n.libstdcxx_abi = 0; }, "_GLIBCXX_USE_CXX11_ABI=0"},
      {[](AbiNote& n) { n.libstdcxx_abi = 2; }, "-stdlib=libc++"},
      {[](AbiNote& n) { n.eigen_alignment *= 2; }, "-mavx"},
      {[](AbiNote& n) { n.sanitizers ^= 1; }, "AddressSanitizer"},
      {[](AbiNote& n) { n.sanitizers ^= 2; }, "ThreadSanitizer"},
      {[](AbiNote& n) { n.fast_math = 1; }, "-ffast-math"},
      {[](AbiNote& n) { n.cpu_features = 1U << 31; }, "features this Stope does not know"}};
  std::set<std::string> sentences;
  for (const auto& [change, part] : cases) {
    const std::string text = complaint(change);
    EXPECT_NE(text.find(part), std::string::npos) << "'" << text << "' lacks '" << part << "'";
    EXPECT_NE(text.find("ebuild"), std::string::npos) << text;
    EXPECT_TRUE(sentences.insert(text).second) << text;
  }
}

TEST(NoteCheck, TellsAllDifferencesAtOnce) {
  const std::string text = complaint([](AbiNote& n) { n.fast_math = 1, n.eigen_alignment *= 2; });
  EXPECT_NE(text.find("-ffast-math"), std::string::npos) << text;
  EXPECT_NE(text.find("Eigen"), std::string::npos) << text;
}

TEST(NoteCheck, RefusesANoteOfAnotherLength) {
  EXPECT_THROW(check_note({make_abi_note("acme", "1.0.0"), false, ""}), PluginRefused);
}

}  // namespace
}  // namespace stope
