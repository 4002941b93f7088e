#include "framework/report/draw/png.hpp"

#include <gtest/gtest.h>

#include "framework/report/draw/base64.hpp"
#include "stope/random.hpp"
#include "tests/framework/report/draw/decoded_png.hpp"

namespace stope::report {
namespace {

Picture random_picture(int width, int height, std::uint64_t colours, std::uint64_t seed) {
  Random random(seed);
  std::vector<Colour> palette(colours);
  for (Colour& colour : palette) {
    for (auto& part : colour) part = static_cast<std::uint8_t>(random.below(256));
  }
  Picture picture{width, height, {}};
  for (int i = 0; i < width * height; ++i) picture.pixels.push_back(palette[random.below(colours)]);
  return picture;
}

TEST(Png, DecodesToThePixelsItWasMadeOf) {
  for (const std::uint64_t colours : {1, 2, 255, 256, 257, 5000}) {
    const Picture picture = random_picture(83, 61, colours, colours);
    const Picture decoded = made::decoded_png(encode_png(picture));
    ASSERT_EQ(decoded.width, 83);
    ASSERT_EQ(decoded.height, 61);
    EXPECT_EQ(decoded.pixels, picture.pixels) << colours << " colours";
  }
}

TEST(Png, GivesTheSameBytesAgain) {
  const Picture picture = random_picture(40, 30, 100, 1);
  EXPECT_EQ(encode_png(picture), encode_png(picture));
}

TEST(Base64, AgreesWithRfc4648) {
  const auto text = [](const std::string& bytes) {
    return base64(std::vector<std::uint8_t>(bytes.begin(), bytes.end()));
  };
  EXPECT_EQ(text(""), "");
  EXPECT_EQ(text("f"), "Zg==");
  EXPECT_EQ(text("fo"), "Zm8=");
  EXPECT_EQ(text("foo"), "Zm9v");
  EXPECT_EQ(text("foobar"), "Zm9vYmFy");
}

}  // namespace
}  // namespace stope::report
