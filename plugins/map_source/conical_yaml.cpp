#include "plugins/map_source/conical_yaml.hpp"

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <unordered_map>

#include "stope/error.hpp"

namespace stope::map_source {
namespace {

/// Reads numbers from a node's own text, so that each bit of them comes back.
template <class Number>
bool parse(const std::string& text, Number& value) {
  if constexpr (std::is_same_v<Number, double>) {
    if (text == ".nan") return value = std::numeric_limits<double>::quiet_NaN(), true;
    if (text == ".inf") return value = std::numeric_limits<double>::infinity(), true;
    if (text == "-.inf") return value = -std::numeric_limits<double>::infinity(), true;
  }
  const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), value);
  return problem == std::errc() && end == text.data() + text.size();
}

class Reader {
 public:
  explicit Reader(const std::filesystem::path& file) {
    map_.file = file.string();
    try {
      document_ = YAML::LoadFile(map_.file);
    } catch (const YAML::BadFile&) {
      throw Error(fmt::format("the conical map {} cannot be opened", map_.file));
    } catch (const YAML::Exception& error) {
      map_.fail(error.mark.line + 1, fmt::format("this is not YAML: {}", error.msg));
    }
    if (!document_.IsMap())
      map_.fail(1, "this is no conical map's yaml: expected keys such as image and topology");
  }

  ConicalYaml read() {
    read_picture();
    read_rule();
    const YAML::Node stope = document_["stope"];
    if (stope.IsDefined()) read_stope(stope);
    const YAML::Node topology = document_["topology"];
    if (!topology.IsDefined() || !topology.IsSequence())
      map_.fail(line_of(topology), "'topology' is missing or no list: expected the vertices");
    for (const YAML::Node& vertex : topology) read_vertex(vertex);
    const YAML::Node count = need(document_, "vertices");
    if (number<std::uint64_t>(count, "vertices") != map_.vertices.size()) {
      map_.fail(line_of(count), fmt::format("'vertices' is {}, but 'topology' lists {}",
                                            count.Scalar(), map_.vertices.size()));
    }
    return std::move(map_);
  }

 private:
  int line_of(const YAML::Node& node) const {
    return node.IsDefined() ? node.Mark().line + 1 : document_.Mark().line + 1;
  }

  YAML::Node need(const YAML::Node& in, const char* key) const {
    const YAML::Node node = in[key];
    if (!node.IsDefined() || node.IsNull())
      map_.fail(line_of(in), fmt::format("'{}' is missing", key));
    return node;
  }

  template <class Number>
  Number number(const YAML::Node& node, const char* what) const {
    Number value{};
    if (!node.IsScalar() || !parse(node.Scalar(), value)) {
      map_.fail(line_of(node),
                fmt::format("'{}' is wrong: expected {}", what,
                            std::is_integral_v<Number> ? "a whole number" : "a number"));
    }
    return value;
  }

  template <class Number>
  std::vector<Number> numbers(const YAML::Node& node, const char* what) const {
    if (!node.IsSequence())
      map_.fail(line_of(node), fmt::format("'{}' is wrong: expected a list of numbers", what));
    std::vector<Number> values;
    for (const YAML::Node& item : node) values.push_back(number<Number>(item, what));
    return values;
  }

  template <class Number>
  std::vector<Number> numbers(const YAML::Node& node, const char* what, std::size_t count) const {
    std::vector<Number> values = numbers<Number>(node, what);
    if (values.size() != count)
      map_.fail(line_of(node), fmt::format("'{}' is wrong: expected {} numbers", what, count));
    return values;
  }

  double between(const YAML::Node& node, const char* what, double least, double most) const {
    const auto value = number<double>(node, what);
    if (!(value >= least && value <= most)) {
      map_.fail(line_of(node),
                fmt::format("'{}' is {}: expected {} to {}", what, value, least, most));
    }
    return value;
  }

  void read_picture() {
    const YAML::Node image = need(document_, "image");
    if (!image.IsScalar() || image.Scalar().empty())
      map_.fail(line_of(image), "'image' is wrong: expected the name of a PPM picture");
    const std::filesystem::path own = map_.file;
    map_.image = own.parent_path() / image.Scalar();
    // Files are renamed in pairs, and an export does not know what its output is called.
    std::error_code ignored;
    const auto beside = std::filesystem::path(own).replace_extension(".ppm");
    if (!std::filesystem::exists(map_.image, ignored) && std::filesystem::exists(beside, ignored))
      map_.image = beside;
    map_.resolution = between(need(document_, "resolution"), "resolution", 1e-9, 1e9);
    const YAML::Node origin = need(document_, "origin");
    const auto pose = numbers<double>(origin, "origin", 3);
    for (const double value : pose) {
      if (!(std::abs(value) <= 1e9))
        map_.fail(line_of(origin), "'origin' is no place: expected metres, at most 1e9");
    }
    map_.origin = {pose[0], pose[1], pose[2]};
  }

  void read_rule() {
    map_.rule.free_thresh = between(need(document_, "free_thresh"), "free_thresh", 0, 1);
    const YAML::Node occupied = need(document_, "occupied_thresh");
    map_.rule.occupied_thresh = between(occupied, "occupied_thresh", 0, 1);
    if (map_.rule.occupied_thresh <= map_.rule.free_thresh)
      map_.fail(line_of(occupied), "'occupied_thresh' must be above 'free_thresh'");
    const YAML::Node mode = document_["mode"];
    const std::string name = mode.IsDefined() && mode.IsScalar() ? mode.Scalar() : "trinary";
    if (name == "scale") map_.rule.mode = MapMode::kScale;
    if (name == "raw") map_.rule.mode = MapMode::kRaw;
    if (name != "trinary" && name != "scale" && name != "raw")
      map_.fail(line_of(mode), "'mode' is wrong: expected trinary, scale or raw");
    if (const YAML::Node start = document_["hue_start"]; start.IsDefined())
      map_.hue_start = static_cast<int>(between(start, "hue_start", 0, 359));
    if (const YAML::Node step = document_["hue_step"]; step.IsDefined())
      map_.hue_step = static_cast<int>(between(step, "hue_step", 1, 360));
    if (const YAML::Node factor = document_["coefficient"]; factor.IsDefined())
      map_.coefficient = between(factor, "coefficient", 1e-3, 1);
  }

  void read_stope(const YAML::Node& node) {
    if (!node.IsMap()) map_.fail(line_of(node), "'stope' is wrong: expected keys and values");
    const YAML::Node version = need(node, "version");
    if (number<int>(version, "version") != 1)
      map_.fail(line_of(version),
                fmt::format("the map's version is {}: this Stope reads 1 only", version.Scalar()));
    StopeConical& stope = map_.stope.emplace();
    const YAML::Node size = need(node, "size");
    const auto cells = numbers<std::int32_t>(size, "size", 2);
    if (cells[0] < 1 || cells[1] < 1) map_.fail(line_of(size), "'size' is wrong: no cells");
    stope.width = cells[0], stope.height = cells[1];
    const YAML::Node floor = need(node, "floor");
    stope.floor = static_cast<int>(between(floor, "floor", 3, 128));
    check_floor(floor, stope.floor);
    const YAML::Node occupancy = need(node, "occupancy");
    stope.measured = occupancy.IsScalar() && occupancy.Scalar() == "grid";
    if (!stope.measured && !(occupancy.IsScalar() && occupancy.Scalar() == "assumed"))
      map_.fail(line_of(occupancy), "'occupancy' is wrong: expected grid or assumed");
    if (const YAML::Node names = node["label_names"]; names.IsDefined()) {
      for (const YAML::Node& name : names) stope.label_names.push_back(name.Scalar());
    }
    const YAML::Node pieces = need(node, "pieces");
    stope.pieces_line = line_of(pieces);
    if (!pieces.IsScalar()) map_.fail(stope.pieces_line, "'pieces' is wrong: expected numbers");
    const std::string& text = pieces.Scalar();
    for (const char *at = text.data(), *end = at + text.size(); at != end;) {
      if (*at == ' ') {
        ++at;
        continue;
      }
      std::uint32_t piece = 0;
      const auto [next, problem] = std::from_chars(at, end, piece);
      if (problem != std::errc() || (next != end && *next != ' '))
        map_.fail(stope.pieces_line, "'pieces' is wrong: expected numbers between blanks");
      stope.pieces.push_back(piece);
      at = next;
    }
  }

  /// Both say how dark a free cell is, so that a change of one alone is seen.
  void check_floor(const YAML::Node& node, int floor) const {
    constexpr double kFreeInTrinary = 0.196;  // of what is above the floor, as map_server has it
    const double share = floor / 255.0;
    const double expected =
        map_.rule.mode == MapMode::kTrinary ? share + (1 - share) * kFreeInTrinary : share;
    if (std::abs(map_.rule.free_thresh - expected) > 1e-6)
      map_.fail(
          line_of(node),
          fmt::format("'floor' is {}, with which 'free_thresh' would be {}, but it is {}: one "
                      "of them was changed; put it back or export the map again",
                      floor, expected, map_.rule.free_thresh));
  }

  void read_vertex(const YAML::Node& node) {
    ConicalVertex vertex;
    vertex.line = line_of(node);
    if (!node.IsMap()) map_.fail(vertex.line, "a vertex is wrong: expected keys and values");
    const YAML::Node name = node["vertex"];
    vertex.number = name.IsDefined() ? number<std::uint64_t>(name, "vertex") : map_.vertices.size();
    const auto pixel = numbers<double>(need(node, "pixel"), "pixel", 2);
    vertex.pixel_x = pixel[0], vertex.pixel_y = pixel[1];
    const YAML::Node adjacent = need(node, "adjacent");
    vertex.adjacent = numbers<std::uint64_t>(adjacent, "adjacent");
    if (const YAML::Node semantics = node["semantics"]; semantics.IsDefined()) {
      if (!semantics.IsScalar()) map_.fail(line_of(semantics), "'semantics' must be a text");
      vertex.semantics = semantics.Scalar();
    }
    if (map_.stope) read_region(node, vertex);
    map_.vertices.push_back(std::move(vertex));
  }

  void read_region(const YAML::Node& node, ConicalVertex& vertex) const {
    if (vertex.number != map_.vertices.size())
      map_.fail(vertex.line,
                fmt::format("vertex {} stands where vertex {} belongs: one is missing, "
                            "doubled or moved",
                            vertex.number, map_.vertices.size()));
    Region& region = vertex.region;
    region.id = number<std::uint64_t>(need(node, "id"), "id");
    if (!map_.vertices.empty() && region.id <= map_.vertices.back().region.id)
      map_.fail(vertex.line, fmt::format("the id {} is not above the one before", region.id));
    const auto centre = numbers<double>(need(node, "centre"), "centre", 2);
    const auto axes = numbers<double>(need(node, "axes"), "axes", 3);
    region.x = centre[0], region.y = centre[1];
    region.major = axes[0], region.minor = axes[1], region.yaw = axes[2];
    region.area = number<double>(need(node, "area"), "area");
    vertex.cells = number<std::uint64_t>(need(node, "cells"), "cells");
  }

  ConicalYaml map_;
  YAML::Node document_;
};

}  // namespace

void ConicalYaml::fail(int line, const std::string& what) const {
  throw Error(fmt::format("the conical map {}:{}: {}", file, line, what));
}

ConicalYaml read_conical_yaml(const std::filesystem::path& file) { return Reader(file).read(); }

std::vector<std::uint32_t> adjacency_of(const ConicalYaml& map) {
  std::unordered_map<std::uint64_t, std::uint32_t> places;
  for (std::size_t i = 0; i < map.vertices.size(); ++i) {
    const ConicalVertex& vertex = map.vertices[i];
    if (!places.emplace(vertex.number, static_cast<std::uint32_t>(i)).second)
      map.fail(vertex.line, fmt::format("there are two vertices {}", vertex.number));
  }
  std::vector<std::pair<std::uint32_t, std::uint32_t>> directed;
  for (std::size_t i = 0; i < map.vertices.size(); ++i) {
    const ConicalVertex& vertex = map.vertices[i];
    for (const std::uint64_t number : vertex.adjacent) {
      const auto found = places.find(number);
      if (found == places.end() || found->second == i)
        map.fail(vertex.line, fmt::format("vertex {} is adjacent to {}, which is no other vertex "
                                          "of this map",
                                          vertex.number, number));
      directed.emplace_back(static_cast<std::uint32_t>(i), found->second);
    }
  }
  std::sort(directed.begin(), directed.end());
  std::vector<std::uint32_t> pairs;
  for (std::size_t k = 0; k < directed.size(); ++k) {
    const auto [a, b] = directed[k];
    const ConicalVertex& vertex = map.vertices[a];
    if (k > 0 && directed[k - 1] == directed[k])
      map.fail(vertex.line, fmt::format("vertex {} is adjacent to {} twice", vertex.number,
                                        map.vertices[b].number));
    if (!std::binary_search(directed.begin(), directed.end(), std::pair(b, a)))
      map.fail(vertex.line, fmt::format("vertex {} is adjacent to {}, but not the other way round",
                                        vertex.number, map.vertices[b].number));
    if (a < b) pairs.insert(pairs.end(), {a, b});
  }
  return pairs;
}

}  // namespace stope::map_source
