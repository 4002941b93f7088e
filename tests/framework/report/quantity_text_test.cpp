#include "framework/report/quantity_text.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace stope::report {
namespace {

TEST(QuantityText, Lengths) {
  EXPECT_EQ(length_text(0), "0 m");
  EXPECT_EQ(length_text(0.5), "0.5 m");
  EXPECT_EQ(length_text(8.4), "8.4 m");
  EXPECT_EQ(length_text(840.2), "840 m");
  EXPECT_EQ(length_text(12345), "12.3 km");
  EXPECT_EQ(length_text(-2.2), "−2.2 m");
  EXPECT_EQ(length_text(std::numeric_limits<double>::quiet_NaN()), "not known");
}

TEST(QuantityText, Durations) {
  EXPECT_EQ(duration_text(0), "0 ns");
  EXPECT_EQ(duration_text(12'300), "12.3 µs");
  EXPECT_EQ(duration_text(312'000'000), "312 ms");
  EXPECT_EQ(duration_text(1'240'000'000), "1.24 s");
  EXPECT_EQ(duration_text(1'700'000'000), "1.70 s");
  EXPECT_EQ(duration_text(123'000'000'000), "2 min 3 s");
  EXPECT_EQ(duration_text(4'320'000'000'000), "1 h 12 min");
}

TEST(QuantityText, BytesAndCounts) {
  EXPECT_EQ(bytes_text(1000), "1000 B");
  EXPECT_EQ(bytes_text(1536), "1.5 KiB");
  EXPECT_EQ(bytes_text(std::uint64_t{2} << 30), "2 GiB");
  EXPECT_EQ(count_text(999), "999");
  EXPECT_EQ(count_text(1234567), "1\u202f234\u202f567");
  EXPECT_EQ(count_text(1, "loop", "loops"), "1 loop");
  EXPECT_EQ(count_text(0, "loop", "loops"), "0 loops");
}

}  // namespace
}  // namespace stope::report
