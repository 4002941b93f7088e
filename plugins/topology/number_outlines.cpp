// Problem: the numbers of an outline's edges follow each other, but outlines come, go and change
// their lengths.
// Idea: an outline that changed takes a range of numbers that is free, at best of those that others
// left. What it left itself may be looked at until the update is over, so it is free only then. If
// the free ranges are too many and too short, all outlines get numbers anew.
// Cost: linear in the length of the outlines that get numbers.
#include "plugins/topology/number_outlines.hpp"

#include <algorithm>

namespace stope::topology {
namespace {

constexpr std::size_t kFewNumbers = 100000;

std::size_t at(std::int64_t place) { return static_cast<std::size_t>(place); }

/// Gives numbers to the edges of an outline, which `write` writes in order.
template <class Write>
void give_numbers(NamedOutlines& outlines, std::int32_t place, Write write) {
  Outlines &numbered = outlines.by_number, &named = outlines.by_name;
  Outline& whole = numbered.list[at(place)];
  const std::int32_t count = whole.count + named.gap;
  whole.first = outlines.free_numbers.take(count);
  if (whole.first < 0) {
    whole.first = static_cast<OutlineEdge>(outlines.name.size());
    const std::size_t size = outlines.name.size() + at(count);
    outlines.name.resize(size, -1);
    outlines.side_by_number.resize(size);
    numbered.place.resize(size);
    numbered.of_edge.resize(size, -1);
  }
  write(outlines.name.data() + whole.first);
  for (OutlineEdge number = whole.first; number < whole.first + whole.count; ++number) {
    const OutlineEdge name = outlines.name[at(number)];
    outlines.number[at(name)] = number;
    outlines.side_by_number[at(number)] = outlines.side[at(name)];
    numbered.place[at(number)] = named.place[at(name)];
    numbered.of_edge[at(number)] = named.of_edge[at(name)] = place;
  }
}

}  // namespace

std::vector<std::int32_t> number_rings(const std::vector<OutlineRing>& rings,
                                       const std::vector<std::int32_t>& gone,
                                       NamedOutlines& outlines) {
  std::vector<Outline>& list = outlines.by_number.list;
  for (const Outline& left : outlines.left)
    outlines.free_numbers.give_back(left.first, left.count + outlines.by_name.gap);
  outlines.left.clear();
  for (const std::int32_t place : gone) {
    outlines.left.push_back(list[at(place)]);
    list[at(place)].count = 0;
    outlines.unused.push_back(place);
  }
  std::vector<std::int32_t> places;
  for (const OutlineRing& ring : rings) {
    if (outlines.unused.empty()) {
      outlines.unused.push_back(static_cast<std::int32_t>(list.size()));
      list.emplace_back();
    }
    places.push_back(outlines.unused.back());
    outlines.unused.pop_back();
    list[at(places.back())] = ring.outline;
    const auto start = ring.names.begin() + static_cast<std::ptrdiff_t>(ring.start);
    give_numbers(outlines, places.back(), [&](OutlineEdge* names) {
      std::rotate_copy(ring.names.begin(), start, ring.names.end(), names);
    });
  }
  outlines.by_name.list = list;
  return places;
}

bool renumber_if_sparse(NamedOutlines& outlines) {
  std::vector<Outline>& list = outlines.by_number.list;
  std::size_t used = 0;
  for (const Outline& outline : list) used += at(outline.count) + at(outlines.by_name.gap);
  if (outlines.name.size() <= 2 * used + kFewNumbers) return false;
  const std::vector<OutlineEdge> before = std::move(outlines.name);
  outlines.name.clear();
  outlines.side_by_number.clear();
  outlines.by_number.place.clear();
  outlines.by_number.of_edge.clear();
  outlines.free_numbers.clear();
  outlines.left.clear();
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (list[i].count == 0) continue;
    const OutlineEdge* names = before.data() + list[i].first;
    const std::int32_t count = list[i].count;
    give_numbers(outlines, static_cast<std::int32_t>(i),
                 [&](OutlineEdge* to) { std::copy_n(names, count, to); });
  }
  outlines.by_name.list = list;
  return true;
}

NamedOutlines::NamedOutlines(const Outlines& outlines, const EdgeGrid& edges)
    : by_name(outlines), by_number(outlines), side(outlines.place.size(), 0) {
  by_number.sides.clear();
  number.resize(outlines.place.size(), -1);
  for (std::size_t i = 0; i < number.size(); ++i) {
    if (outlines.of_edge[i] < 0) continue;
    const auto edge = static_cast<OutlineEdge>(i);
    const Outlines::Place place = outlines.place[i];
    const auto& sides = outlines.sides[at(edges[edges.index(place.column, place.row)])];
    number[i] = edge;
    side[i] =
        static_cast<std::uint8_t>(std::find(sides.begin(), sides.end(), edge) - sides.begin());
  }
  name = number;
  side_by_number = side;
}

}  // namespace stope::topology
