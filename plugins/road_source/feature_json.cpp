#include "plugins/road_source/feature_json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <string_view>

#include "stope/error.hpp"

namespace stope::road_source {
namespace {

using nlohmann::json;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kFarthest = 1e9;  // metres: beyond, a double no longer tells micrometres apart

}  // namespace

FeatureJson::FeatureJson(const std::string& file, const FeatureText& text, std::uint32_t number)
    : file_(file), origin_{number, text.line} {
  try {
    json_ = json::parse(text.text);
  } catch (const json::parse_error& error) {
    const std::size_t place = std::min<std::size_t>(error.byte, text.text.size());
    origin_.line += static_cast<std::uint32_t>(std::count(
        text.text.begin(), text.text.begin() + static_cast<std::ptrdiff_t>(place), '\n'));
    fail(fmt::format("this is not JSON ({})", std::string_view(error.what()).substr(0, 240)));
  } catch (const json::exception& error) {
    // The parser repeats numbers in full, however long.
    fail(fmt::format("this cannot be read ({})", std::string_view(error.what()).substr(0, 160)));
  }
  if (!json_.is_object()) fail("this is no feature: expected an object");
}

const json& FeatureJson::object(const json& in, const char* key) const {
  const auto found = in.find(key);
  if (found == in.end()) fail(fmt::format("'{}' is missing", key));
  if (!found->is_object()) {
    fail(found->is_string()
             ? fmt::format("'{}' is a text and must be an object: some editors (QGIS among them) "
                           "save objects as text",
                           key)
             : fmt::format("'{}' must be an object", key));
  }
  return *found;
}

const json& FeatureJson::list(const json& in, const char* key) const {
  const auto found = in.find(key);
  if (found == in.end()) fail(fmt::format("'{}' is missing", key));
  if (!found->is_array()) fail(fmt::format("'{}' must be a list", key));
  return *found;
}

std::uint32_t FeatureJson::nav2_id(const json& in, const char* key) const {
  const auto found = in.find(key);
  if (found == in.end()) fail(fmt::format("'{}' is missing", key));
  constexpr double kMost = std::numeric_limits<std::uint32_t>::max();
  const double value = found->is_number() ? found->get<double>() : -1;
  if (!(value >= 0 && value <= kMost && value == std::floor(value))) {
    fail(fmt::format("'{}' is {}: expected a whole number from 0 to 4294967295", key,
                     found->dump().substr(0, 40)));
  }
  return static_cast<std::uint32_t>(value);
}

std::uint64_t FeatureJson::stope_id(const json& in, const char* key) const {
  const auto found = in.find(key);
  if (found == in.end()) fail(fmt::format("'{}' is missing", key));
  if (found->is_number_unsigned()) return found->get<std::uint64_t>();
  if (found->is_string()) {
    const auto& text = found->get_ref<const std::string&>();
    std::uint64_t id = 0;
    const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), id);
    if (problem == std::errc() && end == text.data() + text.size()) return id;
  }
  fail(fmt::format("'{}' is {}: expected a whole number below 2^64", key,
                   found->dump().substr(0, 40)));
}

std::uint32_t FeatureJson::count(const json& in, const char* key) const {
  const std::uint32_t value = nav2_id(in, key);
  if (value == 0) fail(fmt::format("'{}' is 0: expected 1 or more", key));
  return value;
}

double FeatureJson::real(const json& value, const char* what) const {
  if (!value.is_number())
    fail(fmt::format("{} is {}: expected a number", what, value.dump().substr(0, 40)));
  return value.get<double>();
}

double FeatureJson::any_number(const json& value, const char* what) const {
  if (value.is_string()) {
    const auto& text = value.get_ref<const std::string&>();
    if (text == "nan" || text == "-nan") return kNaN;
    if (text == "inf") return std::numeric_limits<double>::infinity();
    if (text == "-inf") return -std::numeric_limits<double>::infinity();
  }
  return real(value, what);
}

double FeatureJson::number(const json& in, const char* key) const {
  const auto found = in.find(key);
  return found == in.end() ? kNaN : any_number(*found, key);
}

RoadVertex FeatureJson::position(const json& value) const {
  if (!value.is_array() || value.size() < 2)
    fail("a position is not a list of two or three numbers [x, y, z]");
  const RoadVertex at{real(value[0], "a coordinate"), real(value[1], "a coordinate"),
                      value.size() > 2 ? real(value[2], "a height") : kNaN, 0};
  if (!(std::max(std::abs(at.x), std::abs(at.y)) <= kFarthest)) {
    fail(
        fmt::format("the position ({:g}, {:g}) is no place in metres: expected at most {:g} from "
                    "the origin",
                    at.x, at.y, kFarthest));
  }
  return at;
}

void FeatureJson::fail(const std::string& what) const {
  throw Error(fmt::format("the road graph {}:{}: feature {}{}: {}", file_, origin_.line,
                          origin_.feature, name_.empty() ? "" : fmt::format(" ({})", name_), what));
}

}  // namespace stope::road_source
