#pragma once

#include <fmt/format.h>

#include <string>

#include "framework/diagnostics/diagnostic.hpp"

namespace stope::report {

/// `pipeline.yaml:12:7: sentence hint`, without colour or severity.
inline std::string diagnostic_text(const Diagnostic& diagnostic) {
  std::string text = diagnostic.place.file;
  if (diagnostic.place.line > 0)
    text += fmt::format(":{}:{}", diagnostic.place.line, diagnostic.place.column);
  if (!text.empty()) text += ": ";
  text += diagnostic.sentence;
  if (!diagnostic.hint.empty()) text += " " + diagnostic.hint;
  return text;
}

}  // namespace stope::report
