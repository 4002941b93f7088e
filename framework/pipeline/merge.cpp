#include "framework/pipeline/merge.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "framework/pipeline/codes.hpp"

namespace stope {
namespace {

struct Section {
  const char* key;
  const char* one;  ///< what an entry of it is called
};
constexpr Section kSections[] = {{"vars", "variable"}, {"stages", "stage"}, {"outputs", "output"}};

bool same_place(const Place& a, const Place& b) {
  return a.file == b.file && a.line == b.line && a.column == b.column;
}

LocatedEntry& section_of(LocatedNode& root, const LocatedEntry& like) {
  if (LocatedEntry* found = root.find(like.key)) return *found;
  LocatedNode empty;
  empty.kind = LocatedNode::Kind::kMap;
  empty.place = like.value.place;
  empty.folder = like.value.folder;
  root.entries.push_back({like.key, like.place, empty});
  return root.entries.back();
}

void put(LocatedNode& map, const LocatedEntry& entry) {
  if (LocatedEntry* before = map.find(entry.key)) {
    *before = entry;
  } else {
    map.entries.push_back(entry);
  }
}

// A stage laid over the included one of the same name: `params` by name, everything else by key.
void overlay_stage(LocatedEntry& below, const LocatedEntry& above) {
  if (!below.value.is_map() || !above.value.is_map()) {
    below = above;
    return;
  }
  below.place = above.place;
  below.value.place = above.value.place;
  for (const LocatedEntry& entry : above.value.entries) {
    LocatedEntry* before = below.value.find(entry.key);
    if (entry.key == "params" && before && before->value.is_map() && entry.value.is_map()) {
      for (const LocatedEntry& parameter : entry.value.entries) put(before->value, parameter);
    } else {
      put(below.value, entry);
    }
  }
}

}  // namespace

void merge_included(LocatedNode& below, const LocatedNode& other, const LocatedNode& above,
                    Diagnostics& diagnostics) {
  for (const Section& section : kSections) {
    const LocatedEntry* added = other.find(section.key);
    if (!added || !added->value.is_map()) continue;
    LocatedNode& map = section_of(below, *added).value;
    const LocatedEntry* decided = above.find(section.key);
    for (const LocatedEntry& entry : added->value.entries) {
      const LocatedEntry* before = map.find(entry.key);
      if (before && !same_place(before->place, entry.place) &&
          !(decided && decided->value.find(entry.key))) {
        diagnostics.error(
            code::kIncludeConflict, entry.place,
            fmt::format("The {} '{}' is also defined at {}, and both files are included.",
                        section.one, entry.key, to_text(before->place)),
            fmt::format("Rename one, or define '{}' in the file that includes both.", entry.key));
      }
      put(map, entry);
    }
  }
}

void overlay(LocatedNode& below, const LocatedNode& above) {
  for (const LocatedEntry& entry : above.entries) {
    const bool section = std::any_of(std::begin(kSections), std::end(kSections),
                                     [&](const Section& s) { return entry.key == s.key; });
    if (!section || !entry.value.is_map()) {
      put(below, entry);
      continue;
    }
    LocatedNode& map = section_of(below, entry).value;
    for (const LocatedEntry& part : entry.value.entries) {
      LocatedEntry* before = map.find(part.key);
      if (before && part.value.is_empty() && entry.key != "vars") {
        std::erase_if(map.entries, [&](const LocatedEntry& e) { return e.key == part.key; });
      } else if (before && entry.key == "stages") {
        overlay_stage(*before, part);
      } else {
        put(map, part);
      }
    }
  }
}

}  // namespace stope
