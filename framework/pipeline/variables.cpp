// Problem: values repeated over a pipeline should be written once. Idea: replace on the parsed
// tree, never on text, so that types and places survive; resolve each variable once, depth first,
// with the chain of open ones at hand to name a cycle. Cost: linear in the size of the result,
// which is capped, because variables that repeat variables grow exponentially.
#include "framework/pipeline/variables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <utility>

#include "framework/pipeline/codes.hpp"
#include "framework/pipeline/sentence.hpp"

namespace stope {
namespace {

constexpr std::size_t kMostSpent = 100'000;
constexpr std::size_t kLongestChain = 64;

bool is_name(std::string_view text) {
  const auto plain = [](char c) {
    return c == '_' || (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
  };
  return !text.empty() && (text[0] < '0' || text[0] > '9') && text[0] != '-' &&
         std::all_of(text.begin(), text.end(), [&](char c) { return plain(c) || c == '-'; });
}

LocatedNode broken_at(const LocatedNode& node) {
  LocatedNode result;
  result.place = node.place;
  result.broken = true;
  return result;
}

}  // namespace

Variables::Variables(const LocatedNode* vars, Diagnostics& diagnostics)
    : vars_(vars), diagnostics_(&diagnostics) {}

bool Variables::spend(std::size_t amount, const Place& place) {
  spent_ += amount;
  if (spent_ <= kMostSpent) return true;
  if (!exhausted_)
    diagnostics_->error(code::kVariableExpansion, place,
                        "The variables of this file expand to more than 100000 values or bytes.",
                        "Remove variables that repeat other variables.");
  exhausted_ = true;
  return false;
}

std::optional<std::vector<Variables::Piece>> Variables::split(const LocatedNode& node) {
  std::vector<Piece> pieces;
  std::string plain;
  const auto refuse = [&](std::string sentence, std::string hint) {
    diagnostics_->error(code::kMalformedVariable, node.place, std::move(sentence), std::move(hint));
    return std::nullopt;
  };
  const std::string_view text = node.text;
  for (std::size_t at = 0; at < text.size();) {
    if (text[at] != '$' || at + 1 >= text.size() || (text[at + 1] != '$' && text[at + 1] != '{')) {
      plain.push_back(text[at++]);
      continue;
    }
    if (text[at + 1] == '$') {
      plain.push_back('$');
      at += 2;
      continue;
    }
    const std::size_t end = text.find('}', at);
    if (end == std::string_view::npos)
      return refuse(
          fmt::format("'{}' begins a variable with '${{' and never ends it.", shown(text)),
          "Write ${name}; a dollar sign itself is $$.");
    const std::string name(text.substr(at + 2, end - at - 2));
    if (!is_name(name))
      return refuse(
          fmt::format("'${{{}}}' is not a variable: '{}' is not a name.", shown(name), shown(name)),
          "Names have letters, digits, '_' and '-', and begin with a letter or '_'.");
    if (!plain.empty()) pieces.push_back({false, std::exchange(plain, {})});
    pieces.push_back({true, name});
    at = end + 1;
  }
  if (!plain.empty()) pieces.push_back({false, plain});
  return pieces;
}

LocatedNode Variables::resolve(const LocatedNode& node) {
  if (!spend(1, node.place)) return broken_at(node);
  if (node.is_scalar()) return resolve_scalar(node);
  LocatedNode result = node;
  for (LocatedNode& item : result.items) item = resolve(item);
  for (LocatedEntry& entry : result.entries) {
    if (entry.key.find("${") != std::string::npos)
      diagnostics_->error(
          code::kMalformedVariable, entry.place,
          fmt::format("The key '{}' holds a variable; only values can.", shown(entry.key)),
          "Write the name out.");
    entry.value = resolve(entry.value);
  }
  return result;
}

LocatedNode Variables::resolve_scalar(const LocatedNode& node) {
  if (node.text.find('$') == std::string::npos) return node;
  const auto pieces = split(node);
  if (!pieces) return broken_at(node);
  LocatedNode result = node;
  result.text.clear();
  for (std::size_t i = 0; i < pieces->size(); ++i) {
    const Piece& piece = (*pieces)[i];
    if (!piece.variable) {
      result.text.append(piece.text);
      continue;
    }
    const LocatedNode* value = value_of(piece.text, node.place);
    if (!value || value->broken) return broken_at(node);
    if (pieces->size() == 1) {
      if (!spend(node_count(*value), node.place)) return broken_at(node);
      LocatedNode whole = *value;
      if (!whole.origin) whole.origin = LocatedNode::Origin{piece.text, value->place};
      whole.place = node.place;
      return whole;
    }
    if (!value->is_scalar()) {
      diagnostics_->error(
          code::kVariableInText, node.place,
          fmt::format("'${{{}}}' is {}, which cannot stand inside a text.", piece.text,
                      kind_name(*value)),
          fmt::format("Its value is written at {}.",
                      to_text(value->origin ? value->origin->place : value->place)));
      return broken_at(node);
    }
    if (i == 0) result.folder = value->folder;
    if (!spend(value->text.size(), node.place)) return broken_at(node);
    result.text.append(value->text);
  }
  return result;
}

const LocatedNode* Variables::value_of(const std::string& name, const Place& use) {
  const LocatedEntry* entry = vars_ ? vars_->find(name) : nullptr;
  const auto cycle = std::find(open_.begin(), open_.end(), name);
  if (cycle != open_.end()) {
    std::string chain;
    for (auto i = cycle; i != open_.end(); ++i) chain.append(*i).append(" -> ");
    diagnostics_->error(
        code::kVariableCycle, entry ? entry->place : use,
        fmt::format("The variable '{}' is made from itself: {}{}.", name, chain, name),
        "Give one of them a value that names none of the others.");
    return nullptr;
  }
  if (const auto known = resolved_.find(name); known != resolved_.end()) return &known->second;
  if (!entry) return environment(name, use);
  if (open_.size() >= kLongestChain) {
    diagnostics_->error(
        code::kVariableExpansion, entry->place,
        fmt::format("More than {} variables are made from one another here.", kLongestChain));
    return nullptr;
  }
  open_.push_back(name);
  LocatedNode value = resolve(entry->value);
  open_.pop_back();
  return &resolved_.emplace(name, std::move(value)).first->second;
}

const LocatedNode* Variables::environment(const std::string& name, const Place& use) {
  LocatedNode node;
  node.place = use;
  if (const char* text = std::getenv(name.c_str())) {
    node.kind = LocatedNode::Kind::kScalar;
    node.text = text;
    node.origin = LocatedNode::Origin{name, {"environment", 0, 0}};
  } else {
    const bool capitals =
        std::none_of(name.begin(), name.end(), [](char c) { return c >= 'a' && c <= 'z'; });
    const std::vector<std::string> names = vars_ ? vars_->keys() : std::vector<std::string>();
    diagnostics_->error(
        code::kUndefinedVariable, use,
        fmt::format("The variable '{}' is defined neither under vars: nor in the environment.",
                    name),
        did_you_mean(name, names,
                     capitals ? fmt::format("Set it in the environment: export {}=…", name)
                              : fmt::format("Add '{}: …' under vars:.", name)));
    return nullptr;
  }
  return &resolved_.emplace(name, std::move(node)).first->second;
}

std::map<std::string, std::string> Variables::record() {
  std::map<std::string, std::string> result;
  if (!vars_) return result;
  Diagnostics unused;
  Diagnostics* const used = std::exchange(diagnostics_, &unused);
  for (const LocatedEntry& entry : vars_->entries) {
    const LocatedNode* value = value_of(entry.key, entry.place);
    if (value && !value->broken) result[entry.key] = flow_text(*value);
  }
  diagnostics_ = used;
  for (const Diagnostic& problem : unused.sorted())
    diagnostics_->warning(problem.code, problem.place, problem.sentence, problem.hint);
  return result;
}

std::vector<std::string> referenced_variables(const LocatedNode& node) {
  std::vector<std::string> names;
  const auto add = [&names](std::vector<std::string> more) {
    names.insert(names.end(), more.begin(), more.end());
  };
  for (const LocatedNode& item : node.items) add(referenced_variables(item));
  for (const LocatedEntry& entry : node.entries) add(referenced_variables(entry.value));
  for (std::size_t at = node.text.find("${"); at != std::string::npos;
       at = node.text.find("${", at + 2)) {
    const std::size_t end = node.text.find('}', at);
    if (end != std::string::npos) names.push_back(node.text.substr(at + 2, end - at - 2));
  }
  return names;
}

std::string flow_text(const LocatedNode& node) {
  std::string text;
  const auto separate = [&text](bool first) { text.append(first ? "" : ", "); };
  if (node.is_empty()) return "null";
  if (node.is_scalar()) return node.text;
  if (node.is_sequence()) {
    for (std::size_t i = 0; i < node.items.size(); ++i) {
      separate(i == 0);
      text.append(flow_text(node.items[i]));
    }
    return std::string("[").append(text).append("]");
  }
  for (std::size_t i = 0; i < node.entries.size(); ++i) {
    separate(i == 0);
    text.append(node.entries[i].key).append(": ").append(flow_text(node.entries[i].value));
  }
  return std::string("{").append(text).append("}");
}

}  // namespace stope
