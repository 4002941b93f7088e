#pragma once

#include <optional>
#include <vector>

#include "framework/pipeline/source_text.hpp"

namespace YAML {
class Exception;
}

namespace stope {

/// What the reader knows when the parser gives up.
struct ReadingState {
  struct Bracket {
    char sign;  ///< '[' or '{'
    Place place;
  };
  std::vector<Bracket> open_brackets;        ///< not closed yet, outermost first
  std::optional<Place> several_lines_quote;  ///< the last quoted text that spans lines
};

/// Puts a parser's error into words an operator understands.
void report_syntax_error(const YAML::Exception& error, const SourceText& source,
                         const ReadingState& state, Diagnostics& diagnostics);

}  // namespace stope
