#include "framework/pipeline/yaml_syntax.hpp"

#include <fmt/format.h>
#include <yaml-cpp/exceptions.h>

#include <algorithm>
#include <string_view>

#include "framework/pipeline/codes.hpp"

namespace stope {
namespace {

std::string bracket_sentence(const ReadingState& state) {
  if (state.open_brackets.empty()) return "A bracket is not closed.";
  const ReadingState::Bracket& open = state.open_brackets.back();
  return fmt::format("The '{}' opened at {} is not closed before this place.", open.sign,
                     to_text(open.place));
}

// A tab among the blanks that begin the line of `at`, or npos.
std::size_t indenting_tab(std::string_view text, std::size_t at) {
  const std::size_t newline = at == 0 ? std::string_view::npos : text.rfind('\n', at - 1);
  const std::size_t begin = newline == std::string_view::npos ? 0 : newline + 1;
  const std::size_t end = std::min(text.find_first_not_of(" \t", begin), text.size());
  const std::size_t tab = text.find('\t', begin);
  return tab < end ? tab : std::string_view::npos;
}

}  // namespace

void report_syntax_error(const YAML::Exception& error, const SourceText& source,
                         const ReadingState& state, Diagnostics& diagnostics) {
  const std::string_view message = error.msg;
  const auto has = [&](std::string_view part) {
    return message.find(part) != std::string_view::npos;
  };
  const std::size_t at = source.offset(error.mark.line, error.mark.column);
  const std::string& text = source.text();
  const char here = at < text.size() ? text[at] : '\0';
  const Place place = source.place(error.mark.line, error.mark.column);
  const auto report = [&](const char* code, std::string sentence, std::string hint = "") {
    if (state.several_lines_quote && hint.empty())
      hint = fmt::format(
          "The quoted text that begins at {} runs over several lines: is its "
          "closing quote missing?",
          to_text(*state.several_lines_quote));
    diagnostics.error(code, place, std::move(sentence), std::move(hint));
  };

  if (here == '{' && at > 0 && text[at - 1] == '$')
    return report(code::kUnquotedVariable,
                  "Inside brackets a variable must stand in quotes, because YAML takes its '{' for "
                  "the beginning of a map.",
                  "Write \"${name}\".");
  if (has("illegal EOF in scalar"))
    return report(code::kUnclosedQuote, "A quote is opened but never closed.",
                  "Close it on the same line.");
  if (has("referenced anchor"))
    return report(code::kUnknownAnchor, "This alias names an anchor that is not defined above it.",
                  "Define it with '&name' before it is used, or use vars: and \"${name}\".");
  if (has("end of sequence flow"))
    return report(code::kSyntax, bracket_sentence(state),
                  "Write ',' between the values and ']' after the last.");
  if (has("end of map flow"))
    return report(code::kSyntax, bracket_sentence(state),
                  "Write ',' between the entries and '}' after the last.");
  if (const auto tab = indenting_tab(text, at); tab != std::string_view::npos || has("illegal tab"))
    return report(code::kSyntax, "A tab stands where YAML wants spaces.", "Indent with spaces.");
  if (has("illegal map value") || has("illegal map key"))
    return report(code::kSyntax, "A ': ' cannot stand here.",
                  state.several_lines_quote
                      ? ""
                      : "Write one 'key: value' on a line, with a space after each colon, and "
                        "quote a text that holds ': '. The "
                        "cause may stand on the line above.");
  if (has("end of map not found") || has("end of sequence not found"))
    return report(code::kSyntax, "This does not continue what stands above it.",
                  state.several_lines_quote
                      ? ""
                      : "Entries of one map begin in the same column: check the indentation.");
  if (has("illegal block entry"))
    return report(code::kSyntax, "A list's '- ' cannot begin on the line of its key.",
                  "Begin the list on the next line, or write [a, b].");
  if (has("unknown token") && here > ' ')
    return report(code::kSyntax, fmt::format("A value cannot begin with '{}'.", here),
                  "Put it in quotes.");
  if (has("unknown escape"))
    return report(code::kSyntax, "This escape after '\\' is not one that YAML knows.",
                  "Write '\\\\' for a backslash, or use single quotes.");
  if (here == ']' || here == '}') {
    // The parser runs ahead: the innermost bracket may be closed already if the signs agree.
    const bool other_sign = !state.open_brackets.empty() &&
                            state.open_brackets.back().sign != (here == ']' ? '[' : '{');
    return report(
        code::kSyntax,
        other_sign ? bracket_sentence(state) : fmt::format("This '{}' closes nothing.", here),
        other_sign ? fmt::format("Close it before the '{}'.", here) : "Remove it.");
  }
  report(code::kSyntax, fmt::format("The YAML cannot be read here: {}.", message));
}

}  // namespace stope
