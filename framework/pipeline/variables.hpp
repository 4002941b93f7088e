#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "framework/pipeline/located_node.hpp"

namespace stope {

/// Replaces `${name}` by the pipeline's own variables, else by the environment's. A scalar that is
/// exactly `${name}` becomes the variable's value, whatever it is; inside a longer text the value
/// must be a scalar. `$$` is a dollar sign. What cannot be replaced is reported, once, and marked
/// broken.
class Variables {
 public:
  /// `vars` is the map under `vars:`, or null. Both arguments must outlive this object.
  Variables(const LocatedNode* vars, Diagnostics& diagnostics);
  /// A copy of the node with everything in it replaced.
  LocatedNode resolve(const LocatedNode& node);
  /// All variables as text, as far as they can be resolved; problems of those that nothing uses are
  /// warnings.
  std::map<std::string, std::string> record();

 private:
  struct Piece {
    bool variable = false;
    std::string text;
  };
  std::optional<std::vector<Piece>> split(const LocatedNode& node);
  LocatedNode resolve_scalar(const LocatedNode& node);
  /// The variable's value, or null if there is none, which is reported at `use`.
  const LocatedNode* value_of(const std::string& name, const Place& use);
  const LocatedNode* environment(const std::string& name, const Place& use);
  bool spend(std::size_t amount, const Place& place);

  const LocatedNode* vars_;
  Diagnostics* diagnostics_;
  std::map<std::string, LocatedNode> resolved_;
  std::vector<std::string> open_;  ///< variables being resolved, outermost first
  std::size_t spent_ = 0;
  bool exhausted_ = false;
};

/// The names of all variables that a tree refers to.
std::vector<std::string> referenced_variables(const LocatedNode& node);

/// Text of a node in one line, as YAML flow.
std::string flow_text(const LocatedNode& node);

}  // namespace stope
