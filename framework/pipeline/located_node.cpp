#include "framework/pipeline/located_node.hpp"

namespace stope {

const LocatedEntry* LocatedNode::find(std::string_view key) const {
  for (const LocatedEntry& entry : entries)
    if (entry.key == key) return &entry;
  return nullptr;
}

LocatedEntry* LocatedNode::find(std::string_view key) {
  for (LocatedEntry& entry : entries)
    if (entry.key == key) return &entry;
  return nullptr;
}

std::vector<std::string> LocatedNode::keys() const {
  std::vector<std::string> result;
  for (const LocatedEntry& entry : entries) result.push_back(entry.key);
  return result;
}

const char* kind_name(const LocatedNode& node) {
  switch (node.kind) {
    case LocatedNode::Kind::kScalar:
      return "a single value";
    case LocatedNode::Kind::kSequence:
      return "a list";
    case LocatedNode::Kind::kMap:
      return "a map";
    default:
      return "nothing";
  }
}

std::size_t node_count(const LocatedNode& node) {
  std::size_t count = 1;
  for (const LocatedNode& item : node.items) count += node_count(item);
  for (const LocatedEntry& entry : node.entries) count += node_count(entry.value);
  return count;
}

}  // namespace stope
