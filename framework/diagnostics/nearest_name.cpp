// Which name did the person mean? The optimal string alignment distance (Damerau 1964, without
// edits inside a transposed pair) counts insertions, deletions, substitutions and swaps of
// neighbours; letters that differ only in case, and '-' against '_', cost nothing but break ties.
// Cost: product of the lengths, for each candidate.
#include <algorithm>
#include <cctype>
#include <tuple>

#include "framework/diagnostics/diagnostic.hpp"

namespace stope {
namespace {

std::string folded(std::string_view name) {
  std::string result(name);
  for (char& c : result) {
    c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    if (c == '-' || c == ' ') c = '_';
  }
  return result;
}

std::size_t distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before(b.size() + 1), last(b.size() + 1), now(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) last[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    now[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t substitution = last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      now[j] = std::min({last[j] + 1, now[j - 1] + 1, substitution});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        now[j] = std::min(now[j], before[j - 2] + 1);
    }
    before.swap(last);
    last.swap(now);
  }
  return last[b.size()];
}

}  // namespace

std::string nearest_name(std::string_view name, const std::vector<std::string>& candidates) {
  // A name longer than any real one is no misspelling, and would make the table large.
  constexpr std::size_t kLongest = 200;
  if (name.empty() || name.size() > kLongest) return {};
  const std::string wanted = folded(name);
  std::tuple<std::size_t, std::size_t, std::string> best{~std::size_t{0}, 0, ""};
  for (const std::string& candidate : candidates) {
    if (candidate == name || candidate.size() > kLongest) continue;
    const std::size_t far = distance(wanted, folded(candidate));
    // About one edit in three letters: more is another word.
    const std::size_t longer = std::max(name.size(), candidate.size());
    if (far > std::max<std::size_t>(1, (longer + 1) / 3) || far >= longer) continue;
    best = std::min(best, std::tuple(far, distance(name, candidate), candidate));
  }
  return std::get<2>(best);
}

}  // namespace stope
