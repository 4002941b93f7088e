#include "plugins/source/recording/pcd_header.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <limits>

#include "stope/error.hpp"

namespace stope::source {
namespace {

constexpr std::size_t kLongestHead = 64 * 1024;
constexpr std::size_t kMostFields = 1000;
constexpr std::size_t kMostNumbers = 100'000;  // of one field, in a point
constexpr std::size_t kMostPoints = std::size_t{1} << 31;

std::vector<std::string_view> words_of(std::string_view line) {
  std::vector<std::string_view> words;
  while (true) {
    const std::size_t begin = line.find_first_not_of(" \t\r");
    if (begin == std::string_view::npos) return words;
    line.remove_prefix(begin);
    words.push_back(line.substr(0, line.find_first_of(" \t\r")));
    line.remove_prefix(words.back().size());
  }
}

std::string printable(std::string_view word) {
  std::string text(word.substr(0, 40));
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
  return text;
}

std::size_t number(std::string_view word, std::string_view key, std::size_t most) {
  std::size_t value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size() || value > most)
    throw Error(fmt::format("{} has \"{}\" where a number from 0 to {} was expected", key,
                            printable(word), most));
  return value;
}

/// The lines of the head by their first word.
struct Lines {
  std::vector<std::string_view> fields, size, type, count, width, height, points, data;

  std::vector<std::string_view>* find(std::string_view key) {
    if (key == "FIELDS" || key == "COLUMNS") return &fields;
    if (key == "SIZE") return &size;
    if (key == "TYPE") return &type;
    if (key == "COUNT") return &count;
    if (key == "WIDTH") return &width;
    if (key == "HEIGHT") return &height;
    if (key == "POINTS") return &points;
    if (key == "DATA") return &data;
    return nullptr;  // VERSION and VIEWPOINT do not change how points are read
  }
};

std::size_t read_lines(std::string_view bytes, Lines& lines) {
  std::size_t at = 0;
  while (at < bytes.size() && at < kLongestHead) {
    const std::size_t end = bytes.find('\n', at);
    if (end == std::string_view::npos) break;
    std::vector<std::string_view> words = words_of(bytes.substr(at, end - at));
    at = end + 1;
    if (words.empty() || words[0][0] == '#') continue;
    const std::string_view key = words[0];
    auto* values = lines.find(key);
    words.erase(words.begin());
    if (values) *values = words;
    if (key == "DATA") return at;
  }
  throw Error("there is no DATA line at its head: it is not a PCD file, or it is truncated");
}

std::vector<PcdField> fields_of(const Lines& lines) {
  const std::size_t n = lines.fields.size();
  if (n == 0 || n > kMostFields)
    throw Error(fmt::format("its FIELDS line names {} fields; expected 1 to {}", n, kMostFields));
  const auto check = [n](const std::vector<std::string_view>& values, const char* key) {
    if (values.size() != n)
      throw Error(fmt::format("its {} line has {} entries for {} fields", key, values.size(), n));
  };
  check(lines.size, "SIZE");
  check(lines.type, "TYPE");
  if (!lines.count.empty()) check(lines.count, "COUNT");
  std::vector<PcdField> fields(n);
  std::size_t offset = 0;
  for (std::size_t i = 0; i < n; ++i) {
    PcdField& field = fields[i];
    field.name = printable(lines.fields[i]);
    field.size = number(lines.size[i], "SIZE", 8);
    const std::string_view type = lines.type[i];
    const bool whole = type == "I" || type == "U";
    const bool fits = whole
                          ? field.size == 1 || field.size == 2 || field.size == 4 || field.size == 8
                          : type == "F" && (field.size == 4 || field.size == 8);
    if (!fits)
      throw Error(
          fmt::format("its field {} is of type {} with {} bytes; expected F with 4 or 8, or "
                      "I or U with 1, 2, 4 or 8",
                      field.name, printable(type), field.size));
    field.type = type[0];
    field.count = lines.count.empty() ? 1 : number(lines.count[i], "COUNT", kMostNumbers);
    field.offset = offset;
    offset += field.size * field.count;
  }
  return fields;
}

}  // namespace

const PcdField* PcdHeader::find(std::string_view name) const {
  const auto small = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; };
  for (const PcdField& field : fields) {
    if (field.count == 1 && std::equal(field.name.begin(), field.name.end(), name.begin(),
                                       name.end(), [&](char a, char b) { return small(a) == b; }))
      return &field;
  }
  return nullptr;
}

PcdHeader parse_pcd_header(std::string_view bytes) {
  Lines lines;
  PcdHeader header;
  header.body = read_lines(bytes, lines);
  header.fields = fields_of(lines);
  header.stride =
      header.fields.back().offset + header.fields.back().size * header.fields.back().count;
  const auto single = [](const std::vector<std::string_view>& values, const char* key) {
    if (values.size() != 1)
      throw Error(fmt::format("its {} line has {} entries; expected 1", key, values.size()));
    return number(values[0], key, kMostPoints);
  };
  const std::size_t width = single(lines.width, "WIDTH");
  const std::size_t height = lines.height.empty() ? 1 : single(lines.height, "HEIGHT");
  header.points = width * height;
  if (!lines.points.empty() && single(lines.points, "POINTS") != header.points)
    throw Error(fmt::format("it has WIDTH {} and HEIGHT {}, but POINTS {}", width, height,
                            printable(lines.points[0])));
  if (header.points > kMostPoints)
    throw Error(
        fmt::format("it claims {} points; a scan has at most {}", header.points, kMostPoints));
  const std::string_view data = lines.data.empty() ? std::string_view() : lines.data[0];
  if (data == "ascii") {
    header.data = PcdHeader::Data::kAscii;
  } else if (data == "binary") {
    header.data = PcdHeader::Data::kBinary;
  } else if (data == "binary_compressed") {
    header.data = PcdHeader::Data::kBinaryCompressed;
  } else {
    throw Error(fmt::format("its DATA is \"{}\"; expected ascii, binary or binary_compressed",
                            printable(data)));
  }
  return header;
}

}  // namespace stope::source
