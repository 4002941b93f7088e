#include "plugins/source/recording/pcd_columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <limits>

#include "stope/error.hpp"

#if __has_include(<liblzf/lzf.h>)
#include <liblzf/lzf.h>
#else
#include <lzf.h>
#endif

namespace stope::source {
namespace {

using Columns = std::vector<std::vector<double>>;

// LZF turns three bytes into at most 264: a file that claims more lies about its size.
constexpr std::size_t kMostInflation = 88;

template <class T>
double load(const char* at) {
  T value;
  std::memcpy(&value, at, sizeof(T));
  return static_cast<double>(value);
}

using Loader = double (*)(const char*);

Loader loader_of(const PcdField& field) {
  if (field.type == 'F') return field.size == 4 ? load<float> : load<double>;
  const bool sign = field.type == 'I';
  switch (field.size) {
    case 1:
      return sign ? load<std::int8_t> : load<std::uint8_t>;
    case 2:
      return sign ? load<std::int16_t> : load<std::uint16_t>;
    case 4:
      return sign ? load<std::int32_t> : load<std::uint32_t>;
    default:
      return sign ? load<std::int64_t> : load<std::uint64_t>;
  }
}

/// Numbers `step` bytes apart.
std::vector<double> gather(const char* first, std::size_t step, std::size_t count, Loader loader) {
  std::vector<double> values(count);
  for (std::size_t i = 0; i < count; ++i) values[i] = loader(first + i * step);
  return values;
}

Columns read_binary(const PcdHeader& header, std::string_view body,
                    const std::vector<const PcdField*>& wanted) {
  if (header.stride == 0 || body.size() / header.stride < header.points)
    throw Error(
        fmt::format("it ends after {} bytes of points, but {} points of {} bytes were "
                    "expected: it is truncated",
                    body.size(), header.points, header.stride));
  Columns columns;
  for (const PcdField* field : wanted)
    columns.push_back(
        gather(body.data() + field->offset, header.stride, header.points, loader_of(*field)));
  return columns;
}

Columns read_compressed(const PcdHeader& header, std::string_view body,
                        const std::vector<const PcdField*>& wanted) {
  if (body.size() < 8) throw Error("it ends before the sizes of its compressed points");
  std::uint32_t packed = 0, full = 0;
  std::memcpy(&packed, body.data(), 4);
  std::memcpy(&full, body.data() + 4, 4);
  body.remove_prefix(8);
  if (packed > body.size())
    throw Error(
        fmt::format("it ends after {} bytes of compressed points, but {} were expected: it "
                    "is truncated",
                    body.size(), packed));
  if (full != header.points * header.stride)
    throw Error(
        fmt::format("its points unpack to {} bytes, but {} points of {} bytes were expected", full,
                    header.points, header.stride));
  if (full / kMostInflation > packed)
    throw Error(fmt::format("{} compressed bytes cannot unpack to {}", packed, full));
  std::vector<char> unpacked(full);
  if (full > 0 && lzf_decompress(body.data(), packed, unpacked.data(), full) != full)
    throw Error("its compressed points do not unpack: it is damaged");
  // All of a field's numbers lie together, one field after the other.
  Columns columns;
  for (const PcdField* field : wanted)
    columns.push_back(gather(unpacked.data() + field->offset * header.points, field->size,
                             header.points, loader_of(*field)));
  return columns;
}

double parse(std::string_view word, std::size_t point) {
  if (word == "nan" || word == "NaN" || word == "-nan") {
    return std::numeric_limits<double>::quiet_NaN();
  }
  const std::string_view digits = word[0] == '+' ? word.substr(1) : word;
  double value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error == std::errc::result_out_of_range) return std::numeric_limits<double>::quiet_NaN();
  if (error != std::errc() || end != digits.data() + digits.size())
    throw Error(fmt::format("point {} has a word of {} characters that is not a number", point,
                            word.size()));
  return value;
}

Columns read_ascii(const PcdHeader& header, std::string_view body,
                   const std::vector<const PcdField*>& wanted) {
  std::size_t words = 0;
  std::vector<std::size_t> first_word;
  for (const PcdField& field : header.fields) {
    first_word.push_back(words);
    words += field.count;
  }
  // Every number takes a digit and a blank: a larger claim is known before memory is taken.
  if (words == 0 || header.points > (body.size() + 1) / 2 / words)
    throw Error(
        fmt::format("it claims {} points of {} numbers, more than its {} bytes can hold: it "
                    "is truncated",
                    header.points, words, body.size()));
  std::vector<std::size_t> column_of_word(words, wanted.size());
  for (std::size_t k = 0; k < wanted.size(); ++k) {
    const auto place = static_cast<std::size_t>(wanted[k] - header.fields.data());
    column_of_word[first_word[place]] = k;
  }
  Columns columns(wanted.size(), std::vector<double>(header.points));
  for (std::size_t point = 0; point < header.points; ++point) {
    for (std::size_t word = 0; word < words; ++word) {
      const std::size_t begin = body.find_first_not_of(" \t\r\n");
      if (begin == std::string_view::npos)
        throw Error(
            fmt::format("it ends in point {} of {}: it is truncated", point, header.points));
      body.remove_prefix(begin);
      const std::string_view text = body.substr(0, body.find_first_of(" \t\r\n"));
      body.remove_prefix(text.size());
      if (column_of_word[word] < wanted.size())
        columns[column_of_word[word]][point] = parse(text, point);
    }
  }
  return columns;
}

}  // namespace

std::vector<std::vector<double>> read_pcd_columns(const PcdHeader& header, std::string_view bytes,
                                                  const std::vector<const PcdField*>& wanted) {
  const std::string_view body = bytes.substr(std::min(header.body, bytes.size()));
  switch (header.data) {
    case PcdHeader::Data::kBinary:
      return read_binary(header, body, wanted);
    case PcdHeader::Data::kBinaryCompressed:
      return read_compressed(header, body, wanted);
    default:
      return read_ascii(header, body, wanted);
  }
}

}  // namespace stope::source
