#include "framework/pipeline/output_name.hpp"

#include <fmt/format.h>

#include "framework/pipeline/codes.hpp"
#include "framework/pipeline/sentence.hpp"

namespace stope {
namespace {

std::vector<std::string> parts_of(const std::string& name) {
  std::vector<std::string> parts;
  std::size_t begin = 0;
  for (;;) {
    const std::size_t slash = name.find('/', begin);
    parts.push_back(name.substr(begin, slash - begin));
    if (slash == std::string::npos) return parts;
    begin = slash + 1;
  }
}

}  // namespace

bool check_output_name(const std::string& name, const Place& place, Diagnostics& diagnostics) {
  const auto refuse = [&](const char* code, const std::string& why, const std::string& hint) {
    diagnostics.error(code, place, fmt::format("'{}' {}.", shown(name), why), hint);
    return false;
  };
  const char* const kWriteName = "Write a name such as 'roads.geojson' or 'maps/roads.geojson'.";
  if (name.empty()) return refuse(code::kOutputName, "is no name for an output", kWriteName);
  if (name[0] == '/' || name[0] == '~')
    return refuse(code::kOutputName, "would leave the output folder", kWriteName);
  for (const char c : name)
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f || c == '\\' || c == ':')
      return refuse(code::kOutputName, "holds a character that file names should not have",
                    kWriteName);
  const std::vector<std::string> parts = parts_of(name);
  for (const std::string& part : parts) {
    if (part == "..") return refuse(code::kOutputName, "would leave the output folder", kWriteName);
    if (part.empty() || part == ".")
      return refuse(code::kOutputName, "has an empty part between slashes", kWriteName);
    if (part[0] == '.' && &part != &parts.back())
      return refuse(code::kOutputName, "has a part that begins with a dot", kWriteName);
    if (part.size() > 200) return refuse(code::kOutputName, "is too long a name", kWriteName);
  }
  const bool hidden = parts.back()[0] == '.';
  if (hidden && !extensions_of(name).empty())
    return refuse(code::kOutputName, "begins with a dot", kWriteName);
  if (extensions_of(name).empty())
    return refuse(code::kNoExtension,
                  hidden ? "has no name before its extension"
                         : "has no extension, so there is no telling its format",
                  kWriteName);
  return true;
}

std::vector<std::string> extensions_of(const std::string& name) {
  const std::string last = parts_of(name).back();
  std::vector<std::string> result;
  // A dot at the beginning hides a file, it does not begin an extension.
  for (std::size_t dot = last.find('.', 1); dot != std::string::npos; dot = last.find('.', dot + 1))
    if (dot + 1 < last.size()) result.push_back(last.substr(dot + 1));
  return result;
}

std::string stem_of(const std::string& name, const std::string& extension) {
  const std::string last = parts_of(name).back();
  if (!last.ends_with("." + extension)) return last;
  return last.substr(0, last.size() - extension.size() - 1);
}

}  // namespace stope
