#include "framework/pipeline/tree_builder.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "framework/pipeline/codes.hpp"
#include "framework/pipeline/quoted_scalar.hpp"

namespace stope {
namespace {

constexpr std::size_t kDeepest = 64;
constexpr std::size_t kMostNodes = 20'000;

}  // namespace

void TreeBuilder::OnDocumentStart(const YAML::Mark& mark) {
  if (documents_++ == 0) return;
  diagnostics_.error(code::kSeveralDocuments, place(mark),
                     "A second YAML document begins here; a pipeline file holds one.",
                     "Remove the '---' or '...', or put it in a file of its own.");
  throw Abandoned();
}

void TreeBuilder::OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) {
  LocatedNode node = made(LocatedNode::Kind::kEmpty, mark);
  if (is_value_of_map()) {
    Frame& frame = stack_.back();
    const bool elsewhere =
        node.place.line > frame.key_place.line && node.place.column <= frame.key_place.column;
    // The parser marks a value that is not there at whatever comes next.
    if (elsewhere || is_structure_at(mark)) node.place = after_key(frame);
  }
  complete(std::move(node), anchor);
}

void TreeBuilder::OnAlias(const YAML::Mark& mark, YAML::anchor_t anchor) {
  const auto found = anchors_.find(anchor);
  if (found == anchors_.end()) {
    diagnostics_.error(code::kAliasExpansion, place(mark),
                       "This alias stands inside the very value it repeats.",
                       "Write the value out.");
    throw Abandoned();
  }
  nodes_ += found->second.second;
  check_node_count(mark);
  LocatedNode node = found->second.first;
  if (node.is_scalar() || node.is_empty()) node.place = place(mark);
  add(std::move(node), mark);
}

void TreeBuilder::OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                           const std::string& value) {
  check_tag(mark, tag);
  LocatedNode node = made(LocatedNode::Kind::kScalar, mark);
  node.text = value;
  look_at_quotes(mark);
  complete(std::move(node), anchor);
}

void TreeBuilder::OnSequenceStart(const YAML::Mark& mark, const std::string& tag,
                                  YAML::anchor_t anchor, YAML::EmitterStyle::value style) {
  open(LocatedNode::Kind::kSequence, mark, tag, anchor, style);
}

void TreeBuilder::OnMapStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                             YAML::EmitterStyle::value style) {
  open(LocatedNode::Kind::kMap, mark, tag, anchor, style);
}

LocatedNode TreeBuilder::made(LocatedNode::Kind kind, const YAML::Mark& mark) {
  ++nodes_;
  check_node_count(mark);
  LocatedNode node;
  node.kind = kind;
  node.place = place(mark);
  node.folder = source_.folder();
  return node;
}

void TreeBuilder::check_node_count(const YAML::Mark& mark) {
  if (nodes_ <= kMostNodes) return;
  diagnostics_.error(
      code::kAliasExpansion, place(mark),
      fmt::format("Up to here the file holds more than {} values, aliases counted as often as "
                  "they repeat.",
                  kMostNodes),
      "Remove aliases that repeat other aliases.");
  throw Abandoned();
}

void TreeBuilder::check_tag(const YAML::Mark& mark, const std::string& tag) {
  const std::string_view text = source_.text();
  std::size_t at = source_.offset(mark.line, mark.column);
  const std::size_t value = skip_properties(text, at);
  bool tagged = !tag.empty() && tag != "?" && tag != "!";
  while (at < value && !tagged) {
    tagged = text[at] == '!' && (at == 0 || text[at - 1] != '&');
    at = text.find_first_of("!", at + 1);
  }
  if (!tagged) return;
  diagnostics_.error(code::kTag, place(mark),
                     "A YAML tag ('!…') stands here; pipeline files have none.",
                     "Remove it: the parameter's own type decides how a value is read.");
}

void TreeBuilder::look_at_quotes(const YAML::Mark& mark) {
  const std::string_view text = source_.text();
  const std::size_t at = skip_properties(text, source_.offset(mark.line, mark.column));
  if (at >= text.size() || (text[at] != '"' && text[at] != '\'')) return;
  const std::size_t end = quoted_end(text, at);
  if (end == std::string_view::npos) {
    diagnostics_.error(code::kUnclosedQuote, place(mark),
                       fmt::format("The quote ({}) opened here is never closed.", text[at]),
                       "Close it on the same line.");
    throw Abandoned();
  }
  if (text.substr(at, end - at).find('\n') != std::string_view::npos)
    state_.several_lines_quote = place(mark);
}

bool TreeBuilder::is_value_of_map() const {
  return !stack_.empty() && stack_.back().node.is_map() && stack_.back().key;
}

bool TreeBuilder::is_structure_at(const YAML::Mark& mark) const {
  const std::size_t at = source_.offset(mark.line, mark.column);
  const std::string& text = source_.text();
  return at >= text.size() || std::string_view("}],\n\r#").find(text[at]) != std::string::npos;
}

Place TreeBuilder::after_key(const Frame& frame) const {
  const std::string_view text = source_.text();
  const std::size_t begin = source_.offset(frame.key_mark.line, frame.key_mark.column);
  std::size_t at = skip_properties(text, begin);
  if (at < text.size() && (text[at] == '"' || text[at] == '\'')) {
    at = quoted_end(text, at);
  } else {
    at += frame.key->size();
  }
  at = text.find_first_of(":\n", std::min(at, text.size()));
  if (at == std::string_view::npos || text[at] == '\n' || frame.key_place.column == 0)
    return frame.key_place;
  Place result = frame.key_place;
  result.column += static_cast<int>(at + 1 - begin);
  return result;
}

void TreeBuilder::open(LocatedNode::Kind kind, const YAML::Mark& mark, const std::string& tag,
                       YAML::anchor_t anchor, YAML::EmitterStyle::value style) {
  check_tag(mark, tag);
  if (stack_.size() >= kDeepest) {
    diagnostics_.error(code::kTooDeep, place(mark),
                       fmt::format("Values are nested deeper than {} levels here.", kDeepest),
                       "No part of a pipeline needs more than six.");
    throw Abandoned();
  }
  Frame frame;
  frame.node = made(kind, mark);
  frame.mark = mark;
  frame.anchor = anchor;
  frame.flow = style == YAML::EmitterStyle::Flow;
  if (frame.flow)
    state_.open_brackets.push_back({frame.node.is_map() ? '{' : '[', frame.node.place});
  stack_.push_back(std::move(frame));
}

void TreeBuilder::close() {
  Frame frame = std::move(stack_.back());
  stack_.pop_back();
  if (frame.flow) state_.open_brackets.pop_back();
  keep(frame.anchor, frame.node);
  add(std::move(frame.node), frame.mark);
}

void TreeBuilder::complete(LocatedNode node, YAML::anchor_t anchor) {
  keep(anchor, node);
  const YAML::Mark mark = mark_of(node);
  add(std::move(node), mark);
}

YAML::Mark TreeBuilder::mark_of(const LocatedNode& node) {
  YAML::Mark mark;
  mark.line = std::max(0, node.place.line - 1);
  mark.column = std::max(0, node.place.column - 1);
  return mark;
}

void TreeBuilder::keep(YAML::anchor_t anchor, const LocatedNode& node) {
  if (anchor != 0) anchors_[anchor] = {node, node_count(node)};
}

void TreeBuilder::add(LocatedNode node, const YAML::Mark& mark) {
  if (stack_.empty()) {
    root_ = std::move(node);
    return;
  }
  Frame& frame = stack_.back();
  if (frame.node.is_sequence()) {
    frame.node.items.push_back(std::move(node));
  } else if (!frame.key) {
    take_key(frame, std::move(node), mark);
  } else {
    if (!frame.drop)
      frame.node.entries.push_back({std::move(*frame.key), frame.key_place, std::move(node)});
    frame.key.reset();
  }
}

void TreeBuilder::take_key(Frame& frame, LocatedNode node, const YAML::Mark& mark) {
  frame.key = node.text;
  frame.key_place = node.place;
  frame.key_mark = mark;
  frame.drop = true;
  if (!node.is_scalar() || node.text == "<<") frame.node.incomplete = true;
  if (!node.is_scalar()) {
    diagnostics_.error(code::kKeyNotName, node.place,
                       fmt::format("A key must be a name; here stands {}.", kind_name(node)));
  } else if (node.text == "<<") {
    diagnostics_.error(code::kMergeKey, node.place,
                       "'<<' merges maps in some YAML dialects; pipeline files do not have it.",
                       "Use include: for whole files and vars: for values.");
  } else if (const LocatedEntry* before = std::as_const(frame.node).find(node.text)) {
    diagnostics_.error(code::kDuplicateKey, node.place,
                       fmt::format("The key '{}' stands here a second time; the first is at {}.",
                                   node.text, to_text(before->place)),
                       "Remove one of them.");
  } else {
    frame.drop = false;
  }
}

}  // namespace stope
