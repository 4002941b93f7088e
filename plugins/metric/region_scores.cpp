// Problem: how well do regions match labelled rooms?
// Idea: one table of how many cells each room shares with each region has all the counts, of cells
// and of pairs of cells alike: a pair is in one room and one region as often as an entry has pairs.
// Cost: sorting the cells' labels.
#include "plugins/metric/region_scores.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "stope/error.hpp"

namespace stope::metric {
namespace {

using Label = std::int32_t;

double pairs(double count) { return count * (count - 1) / 2; }

struct Overlaps {
  std::map<std::pair<Label, Label>, double> shared;  ///< room, region (0: none): cells
  std::map<Label, double> rooms, regions;
  double cells = 0;
};

Overlaps count_overlaps(std::span<const Label> truth, std::span<const Label> regions) {
  std::vector<std::pair<Label, Label>> cells;
  for (std::size_t i = 0; i < truth.size(); ++i)
    if (truth[i] > 0) cells.emplace_back(truth[i], std::max(regions[i], 0));
  std::sort(cells.begin(), cells.end());
  Overlaps overlaps;
  overlaps.cells = static_cast<double>(cells.size());
  for (std::size_t begin = 0; begin < cells.size();) {
    std::size_t end = begin;
    while (end < cells.size() && cells[end] == cells[begin]) ++end;
    const auto [room, region] = cells[begin];
    const auto count = static_cast<double>(end - begin);
    overlaps.shared[cells[begin]] = count;
    overlaps.rooms[room] += count;
    if (region > 0) overlaps.regions[region] += count;
    begin = end;
  }
  return overlaps;
}

void score_cells(const Overlaps& overlaps, RegionScores& scores) {
  std::map<Label, std::pair<double, Label>> best_of_room;  // cells, region
  std::map<Label, double> best_of_region;
  for (const auto& [labels, count] : overlaps.shared) {
    const auto [room, region] = labels;
    auto& best = best_of_room[room];
    if (region == 0) continue;
    if (count > best.first) best = {count, region};
    best_of_region[region] = std::max(best_of_region[region], count);
  }
  double tp = 0, fp = 0, fn = 0, tn = 0;
  for (const auto& [room, best] : best_of_room) {
    const double size = overlaps.rooms.at(room);
    const double region = best.second > 0 ? overlaps.regions.at(best.second) : 0;
    const double hit = best.first, rest = overlaps.cells - size - region + hit;
    scores.recall += hit / size;
    scores.mcc_mean += matthews_correlation(hit, region - hit, size - hit, rest);
    tp += hit;
    fp += region - hit;
    fn += size - hit;
    tn += rest;
  }
  scores.recall /= static_cast<double>(best_of_room.size());
  scores.mcc_mean /= static_cast<double>(best_of_room.size());
  scores.mcc = matthews_correlation(tp, fp, fn, tn);
  for (const auto& [region, count] : best_of_region)
    scores.precision += count / overlaps.regions.at(region);
  if (!best_of_region.empty()) scores.precision /= static_cast<double>(best_of_region.size());
}

void score_pairs(const Overlaps& overlaps, RegionScores& scores) {
  double both = 0, room = 0, region = 0;
  for (const auto& [labels, count] : overlaps.shared)
    if (labels.second > 0) both += pairs(count);
  for (const auto& [label, count] : overlaps.rooms) room += pairs(count);
  for (const auto& [label, count] : overlaps.regions) region += pairs(count);
  scores.mcc_pairs = matthews_correlation(both, region - both, room - both,
                                          pairs(overlaps.cells) - region - room + both);
}

}  // namespace

double matthews_correlation(double tp, double fp, double fn, double tn) {
  const double margins =
      std::sqrt(tp + fp) * std::sqrt(tp + fn) * std::sqrt(tn + fp) * std::sqrt(tn + fn);
  if (margins > 0) return (tp * tn - fp * fn) / margins;
  // One room and one region alike leave no negative; that is agreement, not chance.
  return fp == 0 && fn == 0 && tp + tn > 0 ? 1 : 0;
}

RegionScores score_regions(std::span<const Label> truth, std::span<const Label> regions) {
  if (truth.size() != regions.size())
    throw Error(
        fmt::format("the true rooms have {} cells but the regions {}; both must be of the "
                    "same map",
                    truth.size(), regions.size()));
  const Overlaps overlaps = count_overlaps(truth, regions);
  if (overlaps.rooms.empty())
    throw Error(
        "there is no true room, so the regions cannot be measured; rooms are the white "
        "parts of the picture, or the labels above 0 of the region map");
  RegionScores scores;
  scores.rooms = overlaps.rooms.size();
  scores.regions = overlaps.regions.size();
  scores.cells = static_cast<std::size_t>(overlaps.cells);
  score_cells(overlaps, scores);
  score_pairs(overlaps, scores);
  return scores;
}

}  // namespace stope::metric
