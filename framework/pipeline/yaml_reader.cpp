// Problem: yaml-cpp's Node forgets places and keeps both of two equal keys, so a checker built on
// it cannot point at a mistake. Idea: listen to its parser's events, which carry line and column,
// and build a tree of our own on a stack of open collections; look up in the text what events do
// not tell. Cost: linear in the text, plus the expansion of aliases, which is capped.
#include "framework/pipeline/yaml_reader.hpp"

#include <yaml-cpp/yaml.h>

#include <sstream>

#include "framework/pipeline/codes.hpp"
#include "framework/pipeline/tree_builder.hpp"
#include "framework/pipeline/yaml_syntax.hpp"

namespace stope {

std::optional<LocatedNode> read_yaml(const SourceText& source, Diagnostics& diagnostics) {
  std::istringstream in(source.text());
  TreeBuilder builder(source, diagnostics);
  try {
    YAML::Parser parser(in);
    while (parser.HandleNextDocument(builder)) {
    }
  } catch (const Abandoned&) {
    return std::nullopt;
  } catch (const YAML::Exception& error) {
    report_syntax_error(error, source, builder.state(), diagnostics);
    return std::nullopt;
  }
  std::optional<LocatedNode> root = builder.take_root();
  if (!root || root->is_empty()) {
    diagnostics.error(
        code::kEmptyFile, source.file(), "Nothing is written in this file.",
        "A pipeline begins with 'stope: 1' and lists its stages; an experiment begins with "
        "'stope_experiment: 1'.");
    return std::nullopt;
  }
  return root;
}

}  // namespace stope
