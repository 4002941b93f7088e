#include <gtest/gtest.h>

#include "framework/cli/byte_size.hpp"
#include "framework/cli/progress_bars.hpp"
#include "framework/cli/stage_text.hpp"

namespace stope {
namespace {

TEST(ByteSize, ReadsWhatPeopleWrite) {
  EXPECT_EQ(parse_byte_size("2GiB"), std::size_t{2} << 30);
  EXPECT_EQ(parse_byte_size("512 MiB"), std::size_t{512} << 20);
  EXPECT_EQ(parse_byte_size("1.5GB"), 1500000000U);
  EXPECT_EQ(parse_byte_size("4096"), 4096U);
  for (const char* wrong : {"", "GiB", "2 gigs", "-1GiB", "0", "nan", "1e300GiB"}) {
    EXPECT_FALSE(parse_byte_size(wrong)) << wrong;
  }
}

TEST(ByteSize, IsPrintedInTheUnitThatFits) {
  EXPECT_EQ(byte_size_text(1000), "1000 B");
  EXPECT_EQ(byte_size_text(std::size_t{3} << 29), "1.5 GiB");
}

TEST(ProgressLine, ShowsShareRateAndTimeLeft) {
  const RunProgress::Process half{"cloud", 50, 0, 0.5, false};
  EXPECT_EQ(progress_line(half, 10, 6),
            "cloud  [############------------]  50 %       50 items  5.0 /s  0:10 left");
}

TEST(ProgressLine, ShowsNoShareWhereNobodyKnowsIt) {
  const RunProgress::Process unknown{"grid", 3, 2, -1, false};
  EXPECT_EQ(progress_line(unknown, 2, 4),
            "grid [                        ]              3 items  1.5 /s");
}

TEST(LimitsText, SaysWhatIsAccepted) {
  ParameterInfo parameter;
  parameter.limits = more_than(0) + at_most(5);
  EXPECT_EQ(limits_text(parameter), "> 0, <= 5");
  parameter.limits = one_of({"a", "b"});
  EXPECT_EQ(limits_text(parameter), "one of a, b");
}

}  // namespace
}  // namespace stope
