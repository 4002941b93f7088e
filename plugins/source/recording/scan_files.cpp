#include "plugins/source/recording/scan_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <system_error>

#include "stope/error.hpp"

namespace stope::source {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// Compares names with digit runs as numbers; equal numbers with more zeros come later, so that the
/// order is total.
bool natural_less(const std::string& a, const std::string& b) {
  std::size_t i = 0, j = 0;
  while (i < a.size() && j < b.size()) {
    if (!is_digit(a[i]) || !is_digit(b[j])) {
      if (a[i] != b[j]) return a[i] < b[j];
      ++i, ++j;
      continue;
    }
    std::size_t i_end = i, j_end = j;
    while (i_end < a.size() && is_digit(a[i_end])) ++i_end;
    while (j_end < b.size() && is_digit(b[j_end])) ++j_end;
    while (i + 1 < i_end && a[i] == '0') ++i;
    while (j + 1 < j_end && b[j] == '0') ++j;
    if (i_end - i != j_end - j) return i_end - i < j_end - j;
    const int order = a.compare(i, i_end - i, b, j, j_end - j);
    if (order != 0) return order < 0;
    i = i_end, j = j_end;
  }
  if ((i < a.size()) != (j < b.size())) return j < b.size();
  return a < b;
}

}  // namespace

std::vector<std::filesystem::path> list_scan_files(const std::filesystem::path& folder,
                                                   const std::string& extension) {
  std::error_code error;
  std::vector<std::filesystem::path> files;
  for (std::filesystem::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error)) {
    if (entry->path().extension() == extension && entry->is_regular_file(error))
      files.push_back(entry->path());
  }
  if (error)
    throw Error(fmt::format("cannot read the folder {}: {}", folder.string(), error.message()));
  if (files.empty())
    throw Error(fmt::format("the folder {} holds no *{} files: give the folder that has the scans",
                            folder.string(), extension));
  std::sort(files.begin(), files.end(), [](const auto& a, const auto& b) {
    return natural_less(a.filename().string(), b.filename().string());
  });
  return files;
}

ItemRange choose_items(std::size_t count, std::int64_t first, std::int64_t last,
                       std::int64_t limit) {
  ItemRange range{static_cast<std::size_t>(first), count};
  if (last >= 0) range.end = std::min(count, static_cast<std::size_t>(last) + 1);
  if (range.first >= range.end)
    throw Error(
        fmt::format("there are {} scans, numbered from 0, and none of them lies from first "
                    "= {} to last = {}",
                    count, first, last));
  if (limit > 0) range.end = std::min(range.end, range.first + static_cast<std::size_t>(limit));
  return range;
}

}  // namespace stope::source
