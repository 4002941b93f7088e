#include "plugins/map_source/map_yaml.hpp"

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "stope/error.hpp"

namespace stope::map_source {
namespace {

class Reader {
 public:
  explicit Reader(const std::filesystem::path& file) : file_(file.string()) {
    try {
      document_ = YAML::LoadFile(file_);
    } catch (const YAML::BadFile&) {
      throw Error(fmt::format("the map {} cannot be opened", file_));
    } catch (const YAML::Exception& error) {
      throw Error(fmt::format("the map {}:{}: this is not YAML: {}", file_, error.mark.line + 1,
                              error.msg));
    }
    if (!document_.IsMap()) {
      throw Error(fmt::format(
          "the map {} is not a map_server yaml: expected keys such as image, resolution and origin",
          file_));
    }
    refuse_doubles();
  }

  template <class T>
  T get(const char* key, const char* expected) const {
    const YAML::Node node = need(key, expected);
    try {
      return node.as<T>();
    } catch (const YAML::Exception&) {
      fail(node, key, expected);
    }
  }

  double number(const char* key, const char* expected) const {
    const double value = get<double>(key, expected);
    if (!std::isfinite(value)) fail(document_[key], key, expected);
    return value;
  }

  bool flag(const char* key) const {
    const char* expected = "0 or 1";
    const YAML::Node node = need(key, expected);
    try {
      return node.as<int>() != 0;
    } catch (const YAML::Exception&) {
      return get<bool>(key, expected);
    }
  }

  bool has(const char* key) const { return document_[key].IsDefined(); }

  [[noreturn]] void fail(const char* key, const char* expected) const {
    fail(document_[key], key, expected);
  }

 private:
  // The parser keeps one of two values, and which is not what a reader of the file would guess.
  void refuse_doubles() const {
    std::map<std::string, int> lines;
    for (const auto& entry : document_) {
      if (!entry.first.IsScalar()) continue;
      const int line = entry.first.Mark().line + 1;
      const auto [other, is_new] = lines.emplace(entry.first.Scalar(), line);
      if (!is_new) {
        throw Error(fmt::format("the map {}:{}: '{}' is given twice, first in line {}", file_, line,
                                other->first, other->second));
      }
    }
  }

  YAML::Node need(const char* key, const char* expected) const {
    const YAML::Node node = document_[key];
    if (!node.IsDefined() || node.IsNull())
      throw Error(fmt::format("the map {} does not say '{}': expected {}", file_, key, expected));
    return node;
  }

  [[noreturn]] void fail(const YAML::Node& node, const char* key, const char* expected) const {
    throw Error(fmt::format("the map {}:{}: '{}' is wrong: expected {}", file_,
                            node.Mark().line + 1, key, expected));
  }

  std::string file_;
  YAML::Node document_;
};

MapMode read_mode(const Reader& reader) {
  if (!reader.has("mode")) return MapMode::kTrinary;
  const char* expected = "trinary, scale or raw";
  const auto mode = reader.get<std::string>("mode", expected);
  if (mode == "trinary") return MapMode::kTrinary;
  if (mode == "scale") return MapMode::kScale;
  if (mode == "raw") return MapMode::kRaw;
  reader.fail("mode", expected);
}

Pose2 read_origin(const Reader& reader) {
  const char* expected = "three numbers [x, y, yaw] in metres and radians, at most 1e9";
  const auto numbers = reader.get<std::vector<double>>("origin", expected);
  if (numbers.size() != 3) reader.fail("origin", expected);
  for (const double number : numbers) {
    if (!(std::abs(number) <= 1e9)) reader.fail("origin", expected);
  }
  return {numbers[0], numbers[1], numbers[2]};
}

}  // namespace

MapYaml read_map_yaml(const std::filesystem::path& file) {
  const Reader reader(file);
  MapYaml map;
  const auto image = reader.get<std::string>("image", "the name of a PNG or PGM picture");
  if (image.empty()) reader.fail("image", "the name of a PNG or PGM picture");
  map.image = file.parent_path() / image;
  const char* metres = "metres a cell, above 0";
  map.resolution = reader.number("resolution", metres);
  if (map.resolution <= 0) reader.fail("resolution", metres);
  map.origin = read_origin(reader);
  map.rule.mode = read_mode(reader);
  map.rule.negate = reader.flag("negate");
  const char* threshold = "a number from 0 to 1, with free_thresh below occupied_thresh";
  map.rule.occupied_thresh = reader.number("occupied_thresh", threshold);
  map.rule.free_thresh = reader.number("free_thresh", threshold);
  if (map.rule.free_thresh < 0 || map.rule.free_thresh > 1) reader.fail("free_thresh", threshold);
  if (map.rule.occupied_thresh > 1 || map.rule.occupied_thresh <= map.rule.free_thresh)
    reader.fail("occupied_thresh", threshold);
  return map;
}

}  // namespace stope::map_source
