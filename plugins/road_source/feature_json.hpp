#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>

#include "plugins/road_source/feature_scanner.hpp"
#include "plugins/road_source/route_records.hpp"
#include "stope/geometry.hpp"

namespace stope::road_source {

/// One parsed feature and what errors call it. Every accessor throws Error, naming file, line,
/// feature and id, where the value is missing or of another kind.
class FeatureJson {
 public:
  FeatureJson(const std::string& file, const FeatureText& text, std::uint32_t number);

  const nlohmann::json& value() const { return json_; }
  Origin origin() const { return origin_; }
  /// From here on errors say `edge 7` beside the feature's number.
  void call(std::string name) { name_ = std::move(name); }

  /// A member that must be an object; `where` says of what it is a member.
  const nlohmann::json& object(const nlohmann::json& in, const char* key) const;
  /// An id as nav2 has them: a whole number below 2^32.
  std::uint32_t nav2_id(const nlohmann::json& in, const char* key) const;
  /// An id of Stope's: a whole number below 2^64, or its digits as text.
  std::uint64_t stope_id(const nlohmann::json& in, const char* key) const;
  std::uint32_t count(const nlohmann::json& in, const char* key) const;
  /// A finite number.
  double real(const nlohmann::json& value, const char* what) const;
  /// A number, or the text "nan", "inf" or "-inf"; NaN if there is no such member.
  double number(const nlohmann::json& in, const char* key) const;
  double any_number(const nlohmann::json& value, const char* what) const;
  /// A position [x, y] or [x, y, z]; z is NaN where it is not given.
  RoadVertex position(const nlohmann::json& value) const;
  const nlohmann::json& list(const nlohmann::json& in, const char* key) const;

  [[noreturn]] void fail(const std::string& what) const;

 private:
  const std::string& file_;
  Origin origin_;
  std::string name_;
  nlohmann::json json_;
};

}  // namespace stope::road_source
