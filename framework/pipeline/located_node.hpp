#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "framework/diagnostics/diagnostic.hpp"

namespace stope {

struct LocatedEntry;

/// A piece of a pipeline file that knows where a person wrote it.
struct LocatedNode {
  enum class Kind : int { kEmpty, kScalar, kSequence, kMap };
  /// The variable a value came through, and where that variable was written.
  struct Origin {
    std::string variable;
    Place place;
  };

  Kind kind = Kind::kEmpty;  ///< empty: nothing is written, or `null`, or `~`
  Place place;
  std::string text;                   ///< of a scalar, without its quotes
  std::vector<LocatedNode> items;     ///< of a sequence
  std::vector<LocatedEntry> entries;  ///< of a map, in the order written, keys unique
  std::string folder;                 ///< what a relative path in this node is relative to
  std::optional<Origin> origin;
  bool broken = false;      ///< its value could not be found out, which has been reported
  bool incomplete = false;  ///< of a map: a key of it was refused, which has been reported

  bool is_empty() const { return kind == Kind::kEmpty; }
  bool is_scalar() const { return kind == Kind::kScalar; }
  bool is_sequence() const { return kind == Kind::kSequence; }
  bool is_map() const { return kind == Kind::kMap; }
  /// The entry with this key, or null. Null also if this is not a map.
  const LocatedEntry* find(std::string_view key) const;
  LocatedEntry* find(std::string_view key);
  /// The keys of a map.
  std::vector<std::string> keys() const;
};

/// One `key: value` of a map.
struct LocatedEntry {
  std::string key;
  Place place;  ///< of the key
  LocatedNode value;
};

/// "a text", "a list", "a map" or "nothing", for sentences.
const char* kind_name(const LocatedNode& node);

/// How many nodes hang below this one, itself included.
std::size_t node_count(const LocatedNode& node);

}  // namespace stope
