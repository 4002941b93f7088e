#include "tests/benchmarks/topology/mine_checks.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "tests/plugins/topology/graph_checks.hpp"
#include "tests/plugins/topology/members.hpp"
#include "tests/plugins/topology/recorded_tracks.hpp"

namespace stope::topology {
namespace {

bool cycles_are_holes(const Member& member, const OccupancyGrid& mine,
                      const std::vector<double>& areas) {
  std::size_t right = 0;
  const double cell = mine.frame.resolution * mine.frame.resolution;
  for (std::size_t i = 0; i < areas.size(); ++i) {
    ExtractionParams params;
    params.min_obstacle_area = areas[i];
    const Betti at_least = betti_of(member.extract(mine, params));
    params.min_obstacle_area = areas[i] + cell;
    const Betti more = betti_of(member.extract(mine, params));
    const auto holes = static_cast<int>(i) + 1;
    if (at_least.cycles == holes && more.cycles == holes - 1) {
      ++right;
    } else {
      fmt::print("  {}: {} cycles at {:.2f} m^2 and {} beyond it, for {} holes\n", member.name,
                 at_least.cycles, areas[i], more.cycles, holes);
    }
  }
  fmt::print("  {:<28} right for {} of {} areas\n", member.name, right, areas.size());
  std::fflush(stdout);
  return right == areas.size();
}

}  // namespace

bool check_mine(const OccupancyGrid& mine) {
  const std::vector<double> areas = hole_areas(mine);
  fmt::print("The whole mine at {} m: holes of {:.2f} m^2, by flooding\n", mine.frame.resolution,
             fmt::join(areas, ", "));
  // Published, in whole square metres.
  const std::vector<double> published{197394, 105024, 22094, 2172, 1319, 1151, 436};
  const bool as_published =
      std::equal(areas.begin(), areas.end(), published.begin(), published.end(),
                 [](double ours, double theirs) { return std::abs(ours - theirs) <= 0.51; });
  fmt::print("  {} the published ones\n", as_published ? "which are" : "WHICH ARE NOT");
  bool right = as_published;
  for (const Member& member : members()) right = cycles_are_holes(member, mine, areas) && right;
  const char* data = std::getenv("STOPE_DATA");
  const auto tracks = read_tracks(std::filesystem::path(data ? data : STOPE_DEFAULT_DATA) /
                                  "open_pit_maps" / "scenarios");
  for (const Member& member : members()) {
    const TrackCover cover = cover_of(tracks, member.extract(mine, {}));
    const double share = cover.within / cover.length;
    fmt::print("  {:<28} {:.2f} % of {:.0f} m of tracks within a road's clearance\n", member.name,
               100 * share, cover.length);
    right = right && (share >= 0.99 || !member.has_dead_ends);
  }
  return right;
}

}  // namespace stope::topology
