#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace stope {

/// A place in a file that a person wrote. Lines and columns count from 1, columns in bytes; 0 means
/// the whole file.
struct Place {
  std::string file;
  int line = 0, column = 0;
};

enum class Severity : int { kError, kWarning, kNote };

/// One thing to tell the person who wrote a pipeline.
struct Diagnostic {
  Severity severity = Severity::kError;
  std::string code;  ///< such as `P012`; docs/diagnostics.md explains each
  Place place;
  std::string sentence;  ///< what is wrong and what was expected
  std::string hint;      ///< what to do, such as the nearest name; may be empty
};

/// Gathers diagnostics so that all errors of a pipeline come in one go.
class Diagnostics {
 public:
  void error(std::string code, Place place, std::string sentence, std::string hint = "");
  void warning(std::string code, Place place, std::string sentence, std::string hint = "");
  void note(std::string code, Place place, std::string sentence, std::string hint = "");
  bool has_errors() const;
  /// Ordered by file, line and column, without repetitions.
  std::vector<Diagnostic> sorted() const;

 private:
  std::vector<Diagnostic> list_;
};

/// `file:line:column`, without the parts that are 0.
std::string to_text(const Place& place);

/// `file:line:column: error[P012]: sentence hint`, the form that editors understand.
std::string to_text(const Diagnostic& diagnostic);

/// The candidate nearest to `name` (by edit distance with transpositions) if it is near enough to
/// be a misspelling; else an empty text.
std::string nearest_name(std::string_view name, const std::vector<std::string>& candidates);

}  // namespace stope
