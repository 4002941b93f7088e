#include "plugins/topology/regions/network.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "stope/random.hpp"

namespace stope::topology {
namespace {

constexpr int kPlaces = 8;

std::vector<RegionLink> random_links(std::uint64_t seed) {
  Random random(seed);
  std::vector<RegionLink> links;
  for (std::int32_t a = 0; a < kPlaces; ++a)
    for (std::int32_t b = a + 1; b < kPlaces; ++b)
      if (random.uniform() < 0.4) links.push_back({a, b, random.uniform(1, 10)});
  return links;
}

using Ways = std::vector<std::vector<double>>;

/// Shortest ways between all places (Floyd 1962).
Ways all_ways(const std::vector<RegionLink>& links) {
  Ways way(kPlaces, std::vector<double>(kPlaces, 1e9));
  for (std::size_t i = 0; i < kPlaces; ++i) way[i][i] = 0;
  for (const RegionLink& link : links) {
    const auto a = static_cast<std::size_t>(link.from), b = static_cast<std::size_t>(link.to);
    way[a][b] = way[b][a] = std::min(way[a][b], link.length);
  }
  for (std::size_t k = 0; k < kPlaces; ++k)
    for (std::size_t i = 0; i < kPlaces; ++i)
      for (std::size_t j = 0; j < kPlaces; ++j)
        way[i][j] = std::min(way[i][j], way[i][k] + way[k][j]);
  return way;
}

std::vector<RegionLink> pick(const std::vector<RegionLink>& links,
                             const std::vector<std::size_t>& places) {
  std::vector<RegionLink> picked;
  for (const std::size_t place : places) picked.push_back(links[place]);
  return picked;
}

double total(const std::vector<RegionLink>& links) {
  double sum = 0;
  for (const RegionLink& link : links) sum += link.length;
  return sum;
}

TEST(Network, TheTreeConnectsWhatWasConnectedAndNoneIsShorter) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const auto links = random_links(seed);
    if (links.size() > 14) continue;
    const auto tree = pick(links, spanning_tree(kPlaces, links));
    const Ways before = all_ways(links), after = all_ways(tree);
    const auto connected = [](const Ways& ways) {
      int count = 0;
      for (const auto& row : ways)
        for (const double way : row) count += way < 1e8 ? 1 : 0;
      return count;
    };
    ASSERT_EQ(connected(before), connected(after));
    double least = 1e9;  // over all subsets that connect as much
    for (std::uint32_t set = 0; set < (1U << links.size()); ++set) {
      std::vector<RegionLink> some;
      for (std::size_t i = 0; i < links.size(); ++i)
        if (set >> i & 1U) some.push_back(links[i]);
      if (some.size() <= tree.size() && total(some) < least &&
          connected(all_ways(some)) == connected(before))
        least = total(some);
    }
    EXPECT_NEAR(total(tree), least, 1e-9) << "seed " << seed;
    if (seed > 20) break;
  }
}

TEST(Network, TheSpannerStretchesNoWayMoreThanItMay) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const auto links = random_links(seed);
    for (const double stretch : {1.0, 1.5, 3.0}) {
      const Ways before = all_ways(links),
                 after = all_ways(pick(links, spanner(kPlaces, links, stretch)));
      for (std::size_t i = 0; i < kPlaces; ++i)
        for (std::size_t j = 0; j < kPlaces; ++j)
          ASSERT_LE(after[i][j], stretch * before[i][j] * (1 + 1e-12)) << "seed " << seed;
    }
  }
}

TEST(Network, ASquareLosesASideToTheTreeAndNoneToATightSpanner) {
  const std::vector<RegionLink> square{{0, 1, 1}, {1, 2, 1}, {2, 3, 1}, {0, 3, 1}};
  EXPECT_EQ(spanning_tree(4, square), (std::vector<std::size_t>{0, 1, 2}));
  EXPECT_EQ(spanner(4, square, 2).size(), 4U);
  EXPECT_EQ(spanner(4, square, 3).size(), 3U);
}

}  // namespace
}  // namespace stope::topology
