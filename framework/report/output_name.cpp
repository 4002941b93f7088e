#include "framework/report/output_name.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "framework/report/pending_file.hpp"
#include "stope/error.hpp"

namespace stope::report {
namespace {

bool has_control_character(std::string_view text) {
  return std::any_of(text.begin(), text.end(),
                     [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; });
}

// Control characters would garble the terminal that shows the sentence.
std::string quoted(std::string_view text) {
  std::string clean(text);
  for (char& c : clean) {
    if (has_control_character({&c, 1})) c = '?';
  }
  return fmt::format("'{}'", clean);
}

}  // namespace

void check_output_name(std::string_view name) {
  const auto refuse = [name](std::string_view why) {
    throw Error(fmt::format(
        "the output name {} {}. Give a name inside the output folder, such as roads.geojson or "
        "maps/roads.geojson.",
        quoted(name), why));
  };
  if (name.empty()) refuse("is empty");
  if (name.size() > 4000) refuse("is too long");
  if (has_control_character(name)) refuse("holds a control character");
  if (name.find('\\') != std::string_view::npos) refuse("holds a backslash");
  if (name.front() == '/') refuse("is an absolute path");
  for (std::size_t begin = 0; begin <= name.size();) {
    const std::size_t end = std::min(name.find('/', begin), name.size());
    const std::string_view part = name.substr(begin, end - begin);
    if (part.empty()) refuse("has an empty part");
    if (part == "..") refuse("leaves the output folder");
    if (part.front() == '.') refuse("has a part that begins with a dot");
    if (part.size() + kPendingSuffix.size() + 1 > 255) refuse("has a part that is too long");
    begin = end + 1;
  }
}

std::string output_stem(std::string_view name, std::string_view extension) {
  const std::string ending = fmt::format(".{}", extension);
  if (name.size() > ending.size() && name.ends_with(ending))
    return std::string(name.substr(0, name.size() - ending.size()));
  const std::size_t slash = name.rfind('/');
  const std::size_t first = slash == std::string_view::npos ? 0 : slash + 1;
  const std::size_t dot = name.rfind('.');
  if (dot == std::string_view::npos || dot <= first) return std::string(name);
  return std::string(name.substr(0, dot));
}

std::string item_stem(std::uint64_t index) { return fmt::format("{:06}", index); }

bool is_item_name(std::string_view name) {
  const std::size_t digits = name.find_first_not_of("0123456789");
  return digits != std::string_view::npos && digits >= 6 && name[digits] == '.';
}

void check_extension(std::string_view extension) {
  if (extension.empty() || extension.front() == '.' || has_control_character(extension) ||
      extension.size() > 64 || extension.find_first_of("/\\") != std::string_view::npos)
    throw Error(fmt::format(
        "the export gave a file the extension {}, which cannot be part of a file's name. This is "
        "a mistake in the export stage.",
        quoted(extension)));
}

}  // namespace stope::report
