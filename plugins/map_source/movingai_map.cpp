#include "plugins/map_source/movingai_map.hpp"

#include <fmt/format.h>

#include <charconv>
#include <fstream>
#include <limits>
#include <string>
#include <string_view>

#include "stope/error.hpp"

namespace stope::map_source {
namespace {

/// The file's lines, counted, without the carriage returns that some copies have.
class Lines {
 public:
  explicit Lines(const std::filesystem::path& file)
      : name_(file.string()), stream_(file, std::ios::binary) {
    if (!stream_) throw Error(fmt::format("the map {} cannot be opened", name_));
  }

  bool next(std::string& line) {
    if (!std::getline(stream_, line)) return false;
    if (!line.empty() && line.back() == '\r') line.pop_back();
    ++number_;
    return true;
  }

  int number() const { return number_; }

  [[noreturn]] void fail_whole(const std::string& what) const {
    throw Error(fmt::format("the map {}: {}", name_, what));
  }
  [[noreturn]] void fail(const std::string& what) const {
    throw Error(fmt::format("the map {}:{}: {}", name_, number_, what));
  }
  [[noreturn]] void fail_at(std::size_t column, const std::string& what) const {
    throw Error(fmt::format("the map {}:{}:{}: {}", name_, number_, column + 1, what));
  }

 private:
  std::string name_;
  std::ifstream stream_;
  int number_ = 0;
};

/// A word of the file as a message may show it: short, and without bytes that move a terminal.
std::string shown(std::string_view text) {
  constexpr std::size_t kMost = 40;
  std::string result(text.substr(0, kMost));
  for (char& letter : result)
    if (letter < ' ' || letter > '~') letter = '?';
  return text.size() > kMost ? result + "…" : result;
}

struct Header {
  std::int32_t width = 0, height = 0;
};

std::int32_t positive(const Lines& lines, std::string_view key, std::string_view text) {
  std::int32_t value = 0;
  const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (problem != std::errc() || end != text.data() + text.size() || value < 1) {
    lines.fail(fmt::format("'{}' is '{}': expected a whole number of cells from 1 to {}", key,
                           shown(text), std::numeric_limits<std::int32_t>::max()));
  }
  return value;
}

Header read_header(Lines& lines) {
  Header header;
  bool type = false;
  for (std::string line; lines.next(line);) {
    if (line == "map") {
      if (!type || header.width == 0 || header.height == 0)
        lines.fail("'map' begins before 'type octile', 'height' and 'width' are all given");
      return header;
    }
    const std::size_t blank = line.find(' ');
    const std::string key = line.substr(0, blank);
    const std::string value = blank == std::string::npos ? "" : line.substr(blank + 1);
    if (key == "type") {
      if (value != "octile")
        lines.fail(fmt::format("the type is '{}': only octile maps can be read", shown(value)));
      type = true;
    } else if (key == "height") {
      header.height = positive(lines, key, value);
    } else if (key == "width") {
      header.width = positive(lines, key, value);
    } else {
      lines.fail(
          "this is not a MovingAI map: expected 'type octile', 'height N', 'width N' and 'map'");
    }
  }
  if (lines.number() == 0) lines.fail_whole("the map is empty");
  lines.fail("the map is cut off before its rows, or is no MovingAI map: there is no line 'map'");
}

/// The cell a letter stands for, or -1.
int cell_of(char letter) {
  switch (letter) {
    case '.':
    case 'G':
    case 'S':
      return OccupancyGrid::kFree;
    case '@':
    case 'O':
    case 'T':
    case 'W':
      return OccupancyGrid::kOccupied;
    default:
      return -1;
  }
}

void refuse_impossible_size(const std::filesystem::path& file, const Header& header) {
  std::error_code problem;
  const auto bytes = static_cast<double>(std::filesystem::file_size(file, problem));
  const double needed = static_cast<double>(header.width) * header.height;
  if (!problem && bytes < needed) {
    throw Error(
        fmt::format("the map {} is cut off: its header says {} x {} cells, and the file has "
                    "only {:.0f} bytes. Copy it again",
                    file.string(), header.width, header.height, bytes));
  }
}

}  // namespace

OccupancyGrid read_movingai_map(const std::filesystem::path& file, double resolution) {
  Lines lines(file);
  const Header header = read_header(lines);
  refuse_impossible_size(file, header);
  OccupancyGrid grid;
  grid.frame = {header.width, header.height, resolution, {}};
  grid.cells.resize(grid.frame.size());
  std::string line;
  for (std::int32_t row = header.height - 1; row >= 0; --row) {
    if (!lines.next(line))
      lines.fail(
          fmt::format("the map is cut off: {} of {} rows are missing", row + 1, header.height));
    if (line.size() != static_cast<std::size_t>(header.width))
      lines.fail(fmt::format("the row has {} cells, but the map's width is {}", line.size(),
                             header.width));
    std::uint8_t* cells = grid.cells.data() + grid.frame.place({0, row});
    for (std::size_t column = 0; column < line.size(); ++column) {
      const int cell = cell_of(line[column]);
      if (cell < 0) {
        lines.fail_at(column, fmt::format("'{}' is no terrain: expected . G S (free) or @ O T W "
                                          "(not)",
                                          shown(std::string_view(line).substr(column, 1))));
      }
      cells[column] = static_cast<std::uint8_t>(cell);
    }
  }
  while (lines.next(line)) {
    if (line.find_first_not_of(" \t") != std::string::npos)
      lines.fail(fmt::format("there are more than the {} rows that 'height' says", header.height));
  }
  return grid;
}

}  // namespace stope::map_source
