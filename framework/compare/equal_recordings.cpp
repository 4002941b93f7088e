#include "framework/compare/equal_recordings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>

#include "framework/pipeline/sentence.hpp"

namespace stope {
namespace {

enum class Likeness : std::uint8_t { kAlike, kUnlike, kUnknown };

/// Whether no arm tells two recordings apart and one at least shows them alike. `tell` is asked of
/// each place in the table.
template <class Tell>
bool alike(const Comparison& comparison, std::size_t recording, std::size_t other, Tell&& tell) {
  bool any = false;
  for (std::size_t arm = 0; arm < comparison.arms.size(); ++arm)
    for (std::size_t seed = 0; seed < comparison.seeds.size(); ++seed) {
      const Likeness likeness =
          tell(comparison.place(arm, recording, seed), comparison.place(arm, other, seed));
      if (likeness == Likeness::kUnlike) return false;
      any = any || likeness == Likeness::kAlike;
    }
  return any;
}

bool more_than_measures(const ComparedCell& cell) {
  return std::any_of(cell.artefacts.begin(), cell.artefacts.end(), [](const CellArtefact& file) {
    return file.kind != CellArtefact::Kind::kMeasures;
  });
}

bool same_sources(const Comparison& comparison, const SourceKeys& sources, std::size_t recording,
                  std::size_t other) {
  return alike(comparison, recording, other, [&](std::size_t a, std::size_t b) {
    if (sources[a].empty() || sources[b].empty()) return Likeness::kUnknown;
    return sources[a] == sources[b] ? Likeness::kAlike : Likeness::kUnlike;
  });
}

bool same_results(const Comparison& comparison, std::size_t recording, std::size_t other) {
  bool files = false;
  const bool same = alike(comparison, recording, other, [&](std::size_t at, std::size_t at_other) {
    const ComparedCell &a = comparison.cells[at], &b = comparison.cells[at_other];
    const bool done = a.status == CellStatus::kDone, other_done = b.status == CellStatus::kDone;
    if (done != other_done)
      return a.status == CellStatus::kFailed || b.status == CellStatus::kFailed
                 ? Likeness::kUnlike
                 : Likeness::kUnknown;
    if (!done) return Likeness::kUnknown;
    files = files || more_than_measures(a);
    return same_outputs(a, b) ? Likeness::kAlike : Likeness::kUnlike;
  });
  return same && files;
}

}  // namespace

void note_equal_recordings(Comparison& comparison, const SourceKeys& sources) {
  std::vector<ComparedRecording>& all = comparison.recordings;
  for (std::size_t first = 0; first < all.size(); ++first) {
    if (!all[first].same_as.empty()) continue;
    bool by_sources = true;
    std::vector<std::string> names;
    for (std::size_t late = first + 1; late < all.size(); ++late) {
      if (!all[late].same_as.empty()) continue;
      const bool sources_are = same_sources(comparison, sources, late, first);
      if (!sources_are && !same_results(comparison, late, first)) continue;
      by_sources = by_sources && sources_are;
      for (ComparedRecording& other : all)
        if (other.same_as == all[late].name) other.same_as = all[first].name;
      all[late].same_as = all[first].name;
      names.push_back(all[late].name);
    }
    if (names.empty()) continue;
    names.insert(names.begin(), all[first].name);
    comparison.warnings.push_back(fmt::format(
        "the recordings {} are one and the same: {}. They count as one recording",
        quoted_list(names),
        by_sources ? "what their sources read or make does not differ"
                   : "every arm left the very same files and figures of them, to the last bit"));
  }
}

}  // namespace stope
