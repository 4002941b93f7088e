#include "framework/diagnostics/diagnostic.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

namespace stope {
namespace {

auto order(const Diagnostic& d) {
  return std::tie(d.place.file, d.place.line, d.place.column, d.severity, d.code, d.sentence,
                  d.hint);
}

const char* severity_name(Severity severity) {
  switch (severity) {
    case Severity::kError:
      return "error";
    case Severity::kWarning:
      return "warning";
    default:
      return "note";
  }
}

}  // namespace

void Diagnostics::error(std::string code, Place place, std::string sentence, std::string hint) {
  list_.push_back(
      {Severity::kError, std::move(code), std::move(place), std::move(sentence), std::move(hint)});
}

void Diagnostics::warning(std::string code, Place place, std::string sentence, std::string hint) {
  list_.push_back({Severity::kWarning, std::move(code), std::move(place), std::move(sentence),
                   std::move(hint)});
}

void Diagnostics::note(std::string code, Place place, std::string sentence, std::string hint) {
  list_.push_back(
      {Severity::kNote, std::move(code), std::move(place), std::move(sentence), std::move(hint)});
}

bool Diagnostics::has_errors() const {
  return std::any_of(list_.begin(), list_.end(),
                     [](const Diagnostic& d) { return d.severity == Severity::kError; });
}

std::vector<Diagnostic> Diagnostics::sorted() const {
  std::vector<Diagnostic> result = list_;
  std::sort(result.begin(), result.end(),
            [](const Diagnostic& a, const Diagnostic& b) { return order(a) < order(b); });
  result.erase(
      std::unique(result.begin(), result.end(),
                  [](const Diagnostic& a, const Diagnostic& b) { return order(a) == order(b); }),
      result.end());
  return result;
}

std::string to_text(const Place& place) {
  std::string text = place.file;
  if (place.line > 0) text.append(":").append(std::to_string(place.line));
  if (place.line > 0 && place.column > 0) text.append(":").append(std::to_string(place.column));
  return text;
}

std::string to_text(const Diagnostic& diagnostic) {
  std::string text = to_text(diagnostic.place);
  if (!text.empty()) text.append(": ");
  text.append(severity_name(diagnostic.severity)).append("[").append(diagnostic.code);
  text.append("]: ").append(diagnostic.sentence);
  if (!diagnostic.hint.empty()) text.append(" ").append(diagnostic.hint);
  return text;
}

}  // namespace stope
