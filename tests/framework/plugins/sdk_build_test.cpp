#include "framework/plugins/sdk_build.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <string>

namespace stope {
namespace {

/// What binutils read in a file.
std::string build_id_by_readelf(const std::string& file) {
  FILE* pipe = ::popen(("readelf -n '" + file + "'").c_str(), "r");
  std::string text;
  std::array<char, 4096> piece{};
  while (std::fgets(piece.data(), piece.size(), pipe)) text += piece.data();
  ::pclose(pipe);
  const std::string mark = "Build ID: ";
  const auto at = text.find(mark);
  return at == std::string::npos
             ? ""
             : text.substr(at + mark.size(), text.find('\n', at) - at - mark.size());
}

// Keys hold it: were it empty, results of another SDK would pass for those of this one.
TEST(SdkBuild, IsTheBuildIdOfTheLibraryThatIsLoaded) {
  const std::string id = sdk_build_id();
  EXPECT_GE(id.size(), 16U);
  EXPECT_EQ(id, build_id_by_readelf(SDK_LIBRARY));
}

}  // namespace
}  // namespace stope
