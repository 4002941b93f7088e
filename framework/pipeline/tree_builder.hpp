#pragma once

#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/mark.h>

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "framework/pipeline/located_node.hpp"
#include "framework/pipeline/source_text.hpp"
#include "framework/pipeline/yaml_syntax.hpp"

namespace stope {

/// Thrown out of the parser once what follows would only repeat an error already reported.
struct Abandoned {};

/// Builds the located tree from a parser's events, on a stack of open collections.
class TreeBuilder final : public YAML::EventHandler {
 public:
  TreeBuilder(const SourceText& source, Diagnostics& diagnostics)
      : source_(source), diagnostics_(diagnostics) {}

  std::optional<LocatedNode> take_root() { return std::move(root_); }
  const ReadingState& state() const { return state_; }

  void OnDocumentStart(const YAML::Mark& mark) override;
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override;
  void OnAlias(const YAML::Mark& mark, YAML::anchor_t anchor) override;
  void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                const std::string& value) override;
  void OnSequenceStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                       YAML::EmitterStyle::value style) override;
  void OnSequenceEnd() override { close(); }
  void OnMapStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                  YAML::EmitterStyle::value style) override;
  void OnMapEnd() override { close(); }

 private:
  struct Frame {
    LocatedNode node;
    YAML::Mark mark;
    YAML::anchor_t anchor = 0;
    bool flow = false;
    std::optional<std::string> key;  ///< of a map: read, its value not yet
    bool drop = false;               ///< the value belongs to a key that was refused
    Place key_place;
    YAML::Mark key_mark;
  };

  Place place(const YAML::Mark& mark) const { return source_.place(mark.line, mark.column); }

  LocatedNode made(LocatedNode::Kind kind, const YAML::Mark& mark);
  void check_node_count(const YAML::Mark& mark);
  void check_tag(const YAML::Mark& mark, const std::string& tag);
  void look_at_quotes(const YAML::Mark& mark);
  bool is_value_of_map() const;
  bool is_structure_at(const YAML::Mark& mark) const;
  /// The place after the colon that follows a frame's key.
  Place after_key(const Frame& frame) const;
  void open(LocatedNode::Kind kind, const YAML::Mark& mark, const std::string& tag,
            YAML::anchor_t anchor, YAML::EmitterStyle::value style);
  void close();
  void complete(LocatedNode node, YAML::anchor_t anchor);
  static YAML::Mark mark_of(const LocatedNode& node);
  void keep(YAML::anchor_t anchor, const LocatedNode& node);
  void add(LocatedNode node, const YAML::Mark& mark);
  void take_key(Frame& frame, LocatedNode node, const YAML::Mark& mark);

  const SourceText& source_;
  Diagnostics& diagnostics_;
  ReadingState state_;
  std::vector<Frame> stack_;
  std::map<YAML::anchor_t, std::pair<LocatedNode, std::size_t>> anchors_;
  std::optional<LocatedNode> root_;
  std::size_t nodes_ = 0;
  int documents_ = 0;
};

}  // namespace stope
