#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "framework/diagnostics/diagnostic.hpp"
#include "stope/testing/memory_context.hpp"

namespace stope::testing {

/// A folder of its own for each test, with what a comparison needs.
class FilesTest : public ::testing::Test {
 protected:
  std::filesystem::path folder() { return context_.temporary_folder(); }
  std::filesystem::path write(const std::string& name, const std::string& text) {
    std::ofstream(folder() / name) << text;
    return folder() / name;
  }
  static std::string read(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    EXPECT_TRUE(in) << file;
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
  }
  /// All diagnostics, one a line.
  static std::string text_of(const Diagnostics& diagnostics) {
    std::string text;
    for (const Diagnostic& diagnostic : diagnostics.sorted()) text += to_text(diagnostic) + "\n";
    return text;
  }

 private:
  MemoryContext context_;
};

}  // namespace stope::testing
