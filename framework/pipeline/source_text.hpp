#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "framework/diagnostics/diagnostic.hpp"

namespace stope {

/// A text to read YAML from, with what is needed to say where in it something stands.
class SourceText {
 public:
  /// `name` is how diagnostics call the file, `folder` what its relative paths are relative to.
  SourceText(std::string text, std::string name, std::string folder);
  /// A text whose every part stands at the same place, such as the value of a `--set`.
  SourceText(std::string text, Place place, std::string folder);

  const std::string& text() const { return text_; }
  const std::string& folder() const { return folder_; }
  /// The whole file.
  Place file() const;
  /// From a line and column that count from 0.
  Place place(int line, int column) const;
  /// Where in text() that line and column are; never beyond its end.
  std::size_t offset(int line, int column) const;

 private:
  std::string text_, folder_;
  Place whole_;
  bool fixed_ = false;
  std::vector<std::size_t> line_starts_;
};

/// Reads a file of a pipeline. Reports one that cannot be read or is not text, and gives nothing
/// then. `asked` is where the file is named, or the file itself.
std::optional<SourceText> read_source(const std::filesystem::path& file, const Place& asked,
                                      Diagnostics& diagnostics);

/// Whether YAML can be read from the text: UTF-8 without NUL, not empty, not huge. Reports what is
/// not.
bool check_source(const SourceText& source, Diagnostics& diagnostics);

}  // namespace stope
