#include "tests/benchmarks/routing/test_networks.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

#include "stope/random.hpp"

namespace stope::planner {
namespace {

std::uint32_t rounded(double cost) {
  return static_cast<std::uint32_t>(std::max<long long>(1, std::llround(cost)));
}

/// A piece of road between two junctions, before it gets its bends.
struct Street {
  std::uint32_t a, b;
  int rank;  // 0 lane, 1 street, 2 main road, 3 trunk road
  std::uint64_t draw;
};

std::uint32_t root(std::vector<std::uint32_t>& parent, std::uint32_t node) {
  while (parent[node] != node) node = parent[node] = parent[parent[node]];
  return node;
}

}  // namespace

std::vector<NodePlace> TestNetwork::places() const {
  std::vector<NodePlace> places(x.size());
  for (std::size_t i = 0; i < x.size(); ++i)
    places[i] = {static_cast<float>(x[i]), static_cast<float>(y[i])};
  return places;
}

TestNetwork lattice(std::uint32_t side, double spread, std::uint64_t seed) {
  TestNetwork network;
  Random random(seed);
  const auto join = [&](std::uint32_t a, std::uint32_t b) {
    const std::uint32_t cost = rounded(10'000 * random.uniform(1, spread));
    network.arcs.push_back({a, b, cost});
    network.arcs.push_back({b, a, cost});
  };
  for (std::uint32_t row = 0; row < side; ++row) {
    for (std::uint32_t column = 0; column < side; ++column) {
      const std::uint32_t node = row * side + column;
      network.x.push_back(10.0 * column);
      network.y.push_back(10.0 * row);
      if (column + 1 < side) join(node, node + 1);
      if (row + 1 < side) join(node, node + side);
    }
  }
  return network;
}

// Junctions on a lattice of 100 m, each moved by up to 35 m. Of the lattice's streets every 4th
// line is a street proper, every 16th a main road, every 64th a trunk road (60, 80, 100 km/h; lanes
// 30 km/h); those of rank 2 and 3 all stay, of the others a spanning tree and 3 in 10 of the rest,
// which leaves dead ends, blocks of all sizes and a mean degree of about 2.6 at junctions. Each
// street gets 1 to 4 bends (nodes of degree 2); 1 in 20 of those not in the tree is one-way. Cost
// is driving time in tenths of a millisecond. side 512 gives 1.1 million nodes.
TestNetwork road_like(std::uint32_t side, std::uint64_t seed) {
  TestNetwork network;
  Random random(seed);
  std::vector<Street> streets;
  for (std::uint32_t row = 0; row < side; ++row) {
    for (std::uint32_t column = 0; column < side; ++column) {
      const std::uint32_t node = row * side + column;
      network.x.push_back(100.0 * column + random.uniform(-35, 35));
      network.y.push_back(100.0 * row + random.uniform(-35, 35));
      const auto rank = [](std::uint32_t line) {
        return line % 64 == 0 ? 3 : line % 16 == 0 ? 2 : line % 4 == 0 ? 1 : 0;
      };
      if (column + 1 < side) streets.push_back({node, node + 1, rank(row), random.bits()});
      if (row + 1 < side) streets.push_back({node, node + side, rank(column), random.bits()});
    }
  }
  std::sort(streets.begin(), streets.end(), [](const Street& a, const Street& b) {
    return std::tuple(-a.rank, a.draw, a.a, a.b) < std::tuple(-b.rank, b.draw, b.a, b.b);
  });
  std::vector<std::uint32_t> parent(network.x.size());
  std::iota(parent.begin(), parent.end(), 0U);
  for (const Street& street : streets) {
    const std::uint32_t a = root(parent, street.a), b = root(parent, street.b);
    const bool tree = a != b;
    parent[a] = b;
    if (!tree && street.rank < 2 && random.uniform() > 0.3) continue;
    constexpr double kSpeeds[] = {30, 60, 80, 100};  // km/h
    const bool one_way = !tree && random.below(20) == 0;
    const std::uint64_t bends = 1 + random.below(4);
    const double x = network.x[street.a], y = network.y[street.a];
    const double dx = network.x[street.b] - x, dy = network.y[street.b] - y;
    std::uint32_t last = street.a;
    for (std::uint64_t i = 1; i <= bends + 1; ++i) {
      std::uint32_t next = street.b;
      if (i <= bends) {
        const double f = static_cast<double>(i) / static_cast<double>(bends + 1);
        const double aside = random.uniform(-0.05, 0.05);
        next = static_cast<std::uint32_t>(network.x.size());
        network.x.push_back(x + f * dx - aside * dy);
        network.y.push_back(y + f * dy + aside * dx);
      }
      const double length =
          std::hypot(network.x[next] - network.x[last], network.y[next] - network.y[last]);
      const std::uint32_t cost = rounded(length / (kSpeeds[street.rank] / 3.6) * 1e4);
      network.arcs.push_back({last, next, cost});
      if (!one_way) network.arcs.push_back({next, last, cost});
      last = next;
    }
  }
  return network;
}

}  // namespace stope::planner
