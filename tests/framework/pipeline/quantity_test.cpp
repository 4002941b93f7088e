#include "framework/pipeline/quantity.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <numbers>

#include "framework/pipeline/unit.hpp"

namespace stope {
namespace {

// The value of a text in a unit; NaN if it is not one.
double in(const char* text, const char* unit) {
  const auto quantity = parse_quantity(text);
  if (!quantity) return std::numeric_limits<double>::quiet_NaN();
  return convert(*quantity, unit).value.value_or(std::numeric_limits<double>::quiet_NaN());
}

TEST(Quantity, DecimalUnitsAreExact) {
  EXPECT_EQ(in("8 m", "m"), 8.0);
  EXPECT_EQ(in("8", "m"), 8.0);
  EXPECT_EQ(in("0.5km", "m"), 500.0);
  EXPECT_EQ(in("57 cm", "m"), 0.57);
  EXPECT_EQ(in("29 cm", "m"), 0.29);
  EXPECT_EQ(in("-3 mm", "m"), -0.003);
  EXPECT_EQ(in("250 ms", "s"), 0.25);
  EXPECT_EQ(in("2 h", "s"), 7200.0);
  EXPECT_EQ(in("1.5 min", "s"), 90.0);
  EXPECT_EQ(in("2 GiB", "B"), 2147483648.0);
  EXPECT_EQ(in("500 MB", "B"), 5e8);
  EXPECT_EQ(in("50 %", ""), 0.5);
  EXPECT_EQ(in("3 ha", "m^2"), 30000.0);
  EXPECT_EQ(in("2 km^2", "m^2"), 2e6);
  EXPECT_EQ(in("2 km²", "m²"), 2e6);
}

TEST(Quantity, CompoundUnits) {
  EXPECT_EQ(in("36 km/h", "m/s"), 10.0);
  EXPECT_EQ(in("600 rpm", "Hz"), 10.0);
  EXPECT_EQ(in("5 1/s", "Hz"), 5.0);
  EXPECT_EQ(in("9.81 m/s^2", "m/s²"), 9.81);
  EXPECT_EQ(in("2 t", "kg"), 2000.0);
}

TEST(Quantity, Angles) {
  EXPECT_DOUBLE_EQ(in("180 deg", "rad"), std::numbers::pi);
  EXPECT_DOUBLE_EQ(in("-90°", "rad"), -std::numbers::pi / 2);
  EXPECT_DOUBLE_EQ(in("30 deg/s", "rad/s"), std::numbers::pi / 6);
}

TEST(Quantity, NumbersAsPeopleWriteThem) {
  EXPECT_EQ(in("+5", ""), 5.0);
  EXPECT_EQ(in(".5", ""), 0.5);
  EXPECT_EQ(in("1e3", ""), 1000.0);
  EXPECT_EQ(in(" 12 ", ""), 12.0);
  EXPECT_EQ(in(".inf", "m"), std::numeric_limits<double>::infinity());
  EXPECT_EQ(in("-inf m", "m"), -std::numeric_limits<double>::infinity());
}

TEST(Quantity, WhatIsNoQuantity) {
  for (const char* text : {"", "m", "nan", ".nan", "--1", "infinity", "+-3", "1e999", ".", "-"})
    EXPECT_FALSE(parse_quantity(text)) << text;
}

TEST(Quantity, OtherDimensionsAreRefused) {
  for (const auto& [text, unit] :
       std::initializer_list<std::pair<const char*, const char*>>{{"8 kg", "m"},
                                                                  {"8 m", ""},
                                                                  {"8 m", "m^2"},
                                                                  {"8 Hz", "rad/s"},
                                                                  {"8 parsec", "m"},
                                                                  {"8 m/", "m"},
                                                                  {"8 m^99", "m"},
                                                                  {"8,5 m", "m"}}) {
    const Conversion conversion = convert(parse_quantity(text).value(), unit);
    EXPECT_FALSE(conversion.value) << text;
    EXPECT_FALSE(conversion.problem.empty()) << text;
  }
}

TEST(Quantity, AUnitNobodyKnowsMustBeWrittenAsIs) {
  EXPECT_EQ(in("8 cells", "cells"), 8.0);
  EXPECT_EQ(in("8", "cells"), 8.0);
  EXPECT_FALSE(convert(parse_quantity("8 m").value(), "cells").value);
}

TEST(Unit, SuggestionsBeginWithTheWantedOne) {
  EXPECT_EQ(units_like("m/s"), (std::vector<std::string>{"m/s", "km/h"}));
  EXPECT_EQ(units_like("rad"), (std::vector<std::string>{"rad", "mrad", "deg"}));
  EXPECT_EQ(units_like("cells"), (std::vector<std::string>{"cells"}));
}

}  // namespace
}  // namespace stope
