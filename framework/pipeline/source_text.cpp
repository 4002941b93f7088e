#include "framework/pipeline/source_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <utility>

#include "framework/pipeline/codes.hpp"

namespace stope {
namespace {

constexpr std::size_t kLargest = std::size_t{1} << 20;
constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";

// The length of the well-formed UTF-8 sequence at `at` (Unicode 15, table 3-7), or 0.
std::size_t sequence_length(std::string_view text, std::size_t at) {
  const auto byte = [&](std::size_t i) {
    return at + i < text.size() ? static_cast<unsigned char>(text[at + i]) : 0U;
  };
  const auto follows = [&](std::size_t i) { return (byte(i) & 0xC0U) == 0x80U; };
  const unsigned first = byte(0);
  if (first < 0x80) return 1;
  if (first >= 0xC2 && first <= 0xDF) return follows(1) ? 2 : 0;
  if (first >= 0xE0 && first <= 0xEF) {
    if (!follows(1) || !follows(2)) return 0;
    if (first == 0xE0 && byte(1) < 0xA0) return 0;
    if (first == 0xED && byte(1) > 0x9F) return 0;
    return 3;
  }
  if (first >= 0xF0 && first <= 0xF4) {
    if (!follows(1) || !follows(2) || !follows(3)) return 0;
    if (first == 0xF0 && byte(1) < 0x90) return 0;
    if (first == 0xF4 && byte(1) > 0x8F) return 0;
    return 4;
  }
  return 0;
}

}  // namespace

SourceText::SourceText(std::string text, std::string name, std::string folder)
    : text_(std::move(text)), folder_(std::move(folder)), whole_{std::move(name), 0, 0} {
  line_starts_.push_back(text_.starts_with(kByteOrderMark) ? kByteOrderMark.size() : 0);
  for (std::size_t i = 0; i < text_.size(); ++i)
    if (text_[i] == '\n') line_starts_.push_back(i + 1);
}

SourceText::SourceText(std::string text, Place place, std::string folder)
    : SourceText(std::move(text), place.file, std::move(folder)) {
  whole_ = std::move(place);
  fixed_ = true;
}

Place SourceText::file() const { return whole_; }

Place SourceText::place(int line, int column) const {
  if (fixed_) return whole_;
  return {whole_.file, line + 1, column + 1};
}

std::size_t SourceText::offset(int line, int column) const {
  if (line < 0 || column < 0 || static_cast<std::size_t>(line) >= line_starts_.size())
    return text_.size();
  return std::min(text_.size(),
                  line_starts_[static_cast<std::size_t>(line)] + static_cast<std::size_t>(column));
}

std::optional<SourceText> read_source(const std::filesystem::path& file, const Place& asked,
                                      Diagnostics& diagnostics) {
  const auto refuse = [&](const std::string& why, const std::string& hint = "") {
    diagnostics.error(code::kUnreadableFile, asked,
                      fmt::format("The pipeline file '{}' {}.", file.string(), why), hint);
    return std::nullopt;
  };
  std::error_code problem;
  const auto status = std::filesystem::status(file, problem);
  if (!std::filesystem::exists(status)) {
    std::vector<std::string> names;
    const auto folder = file.has_parent_path() ? file.parent_path() : ".";
    for (std::filesystem::directory_iterator i(folder, problem), end; !problem && i != end;
         i.increment(problem))
      names.push_back(i->path().filename().string());
    std::sort(names.begin(), names.end());
    const std::string nearest = nearest_name(file.filename().string(), names);
    return refuse("does not exist",
                  nearest.empty() ? std::string() : fmt::format("Its folder holds '{}'.", nearest));
  }
  if (std::filesystem::is_directory(status)) return refuse("is a folder, not a file");
  errno = 0;
  std::ifstream in(file, std::ios::binary);
  std::string text(kLargest + 1, '\0');
  if (in) in.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (!in.is_open() || in.bad())
    return refuse(fmt::format("cannot be read: {}", std::strerror(errno ? errno : EIO)));
  text.resize(static_cast<std::size_t>(in.gcount()));
  const auto folder = std::filesystem::absolute(file, problem).lexically_normal().parent_path();
  SourceText source(std::move(text), file.string(), folder.string());
  if (!check_source(source, diagnostics)) return std::nullopt;
  return source;
}

bool check_source(const SourceText& source, Diagnostics& diagnostics) {
  const std::string& text = source.text();
  if (text.size() > kLargest) {
    diagnostics.error(code::kHugeFile, source.file(),
                      "This file is larger than 1 MiB, which no pipeline is.",
                      "Name large data by its path instead of writing it into the pipeline.");
    return false;
  }
  int line = 0;
  std::size_t line_start = text.starts_with(kByteOrderMark) ? kByteOrderMark.size() : 0;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t length = sequence_length(text, at);
    if (length == 0 || text[at] == '\0') {
      const bool utf16 = at == 0 && (text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff"));
      const int column = static_cast<int>(at - std::min(at, line_start));
      diagnostics.error(
          code::kNotText, source.place(line, column),
          utf16 ? std::string("This file is UTF-16; a pipeline file is UTF-8 text.")
                : fmt::format("This file is not UTF-8 text: byte 0x{:02x} cannot stand here.",
                              static_cast<unsigned char>(text[at])),
          "Save it as UTF-8.");
      return false;
    }
    if (text[at] == '\n') {
      ++line;
      line_start = at + 1;
    }
    at += length;
  }
  return true;
}

}  // namespace stope
