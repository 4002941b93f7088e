#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "plugins/metric/check_graph.hpp"
#include "plugins/metric/geodesics.hpp"
#include "plugins/metric/measure_list.hpp"
#include "plugins/metric/nearest_obstacle.hpp"
#include "plugins/metric/path_similarity.hpp"
#include "plugins/metric/percentile.hpp"
#include "stope/stope.hpp"

namespace stope::metric {
namespace {

// Draws places on the roads, each metre as likely as any other.
class PlacesOnRoads {
 public:
  explicit PlacesOnRoads(const GraphLines& lines) : lines_(lines) {
    for (std::uint32_t e = 0; e < lines.edge_count(); ++e)
      ends_.push_back((ends_.empty() ? 0 : ends_.back()) + lines.length(e));
  }
  RoadPlace draw(Random& random) const {
    const double along = random.uniform(0, ends_.back());
    const auto end = std::upper_bound(ends_.begin(), ends_.end() - 1, along);
    const auto edge = static_cast<std::uint32_t>(end - ends_.begin());
    return {edge, along - (*end - lines_.length(edge))};
  }

 private:
  const GraphLines& lines_;
  std::vector<double> ends_;
};

// Takes the cells from free space that are nearer to an obstacle's edge than `clearance` metres, by
// their centres.
void keep_away(FreeCells& cells, double clearance) {
  const NearestObstacle nearest(cells);
  const double least = clearance / cells.frame.resolution + 0.5;
  for (std::int32_t row = 0; row < cells.frame.height; ++row) {
    for (std::int32_t column = 0; column < cells.frame.width; ++column) {
      const Cell seen = nearest.of({column, row});
      if (std::hypot(seen.column - column, seen.row - row) < least)
        cells.free[cells.frame.place({column, row})] = 0;
    }
  }
}

}  // namespace

class Detour final : public Map<Measures(RoadGraph, OccupancyGrid, Optional<RoadGraph>)> {
 public:
  struct Params : FreeRule {
    std::int64_t pairs = 200;
    double min_distance = 20;
    std::string between = "roads";
    double min_clearance = 0;
  } params;

  static void describe(About<Detour>& about) {
    about.summary("How much longer routes on the graph are than shortest ways through free space.")
        .from("Lozano-Perez and Wesley 1979, An Algorithm for Planning Collision-Free Paths")
        .notes(
            "Length of the route on the graph / exact any-angle geodesic, for random pairs drawn "
            "from the run's seed. Between roads: both places lie on the graph, each metre as "
            "likely. Between free: both are centres of free cells, joined by a geodesic to the "
            "nearest place of the graph, which counts. Pairs that the graph does not join are a "
            "share of their own, not in the percentiles; without any they are infinite. Roads are "
            "driven both ways. With a true graph, its own routes between the same pairs are "
            "measured too, from its places nearest to them: the detours of roads as they are, and "
            "how much longer the graph's routes are than these, which is the extractor's share.")
        .ports("roads", "grid", "truth", "measures")
        .param("pairs", &Params::pairs, between_pairs(), "How many pairs are measured.")
        .param("min_distance", &Params::min_distance, "m", more_than(0.0),
               "Pairs whose geodesic is shorter are drawn again.")
        .param("between", &Params::between, one_of({"roads", "free"}),
               "Where the places lie: on the graph, or anywhere in free space.")
        .param("min_clearance", &Params::min_clearance, "m", at_least(0.0),
               "How far geodesics stay from obstacles, such as half a truck's width; 0: they graze "
               "them.");
    describe_free_rule(about);
  }

  Measures apply(const RoadGraph& roads, const OccupancyGrid& grid,
                 const Optional<RoadGraph>& truth, Context& context) const {
    check_graph(roads, "roads");
    if (truth) check_truth(*truth);
    FreeCells cells = free_cells(grid, params);
    if (params.min_clearance > 0) keep_away(cells, params.min_clearance);
    MeasuredGraph graph(roads);
    std::optional<MeasuredGraph> real;
    if (truth) real.emplace(*truth);
    Result result;
    if (graph.lines.total_length() > 0) {
      result = measure(graph, real ? &*real : nullptr, cells, context);
    } else {
      context.warn("the graph has no roads, so there are no routes: detours are infinite");
    }
    const double tried = static_cast<double>(result.detours.size() + result.apart);
    const double apart = tried > 0 ? static_cast<double>(result.apart) / tried : 1;
    const double worst = percentile(result.detours, 1);
    if (!result.detours.empty())
      context.info(
          fmt::format("the longest detour, {:.3f}, is from ({:.1f}, {:.1f}) to ({:.1f}, "
                      "{:.1f})",
                      worst, result.from.x(), result.from.y(), result.to.x(), result.to.y()));
    warn_of_doubt(result, context);
    MeasureList list(
        fmt::format("{} random pairs between {}, geodesics of at least {} m, any angle, {} m "
                    "from obstacles; {} measured, {} not joined by the graph, {} with a "
                    "place off free space",
                    params.pairs, params.between, params.min_distance, params.min_clearance,
                    result.detours.size(), result.apart, result.off_free));
    list.add("detour_p50", percentile(result.detours, 0.5))
        .add("detour_p95", percentile(result.detours, 0.95))
        .add("detour_max", worst)
        .add("detour_unreachable", apart);
    if (truth)
      list.add("true_detour_p50", percentile(result.true_detours, 0.5))
          .add("true_detour_p95", percentile(result.true_detours, 0.95))
          .add("route_to_true_p50", percentile(result.to_true, 0.5))
          .add("route_to_true_p95", percentile(result.to_true, 0.95))
          .add("route_to_true_max", percentile(result.to_true, 1));
    return list.take();
  }

 private:
  static Limits between_pairs() { return stope::between(1, 100000); }

  struct Result {
    std::vector<double> detours, true_detours, to_true;
    std::size_t apart = 0, off_free = 0, drawn = 0;
    Vector2 from = Vector2::Zero(), to = Vector2::Zero();  // of the longest detour
  };
  // A place to drive from or to, and the way between it and its road.
  struct End {
    Vector2 position;
    RoadPlace road;
    double link = 0;
  };

  Result measure(MeasuredGraph& graph, MeasuredGraph* truth, const FreeCells& cells,
                 Context& context) const {
    Geodesics geodesics(cells);
    const PlacesOnRoads places(graph.lines);
    Random random = context.random();
    const auto draw = [&]() -> std::optional<End> {
      if (params.between == "free") {
        const auto place = draw_free(cells, random);
        return place ? std::optional(joined(*place, graph, geodesics)) : std::nullopt;
      }
      const RoadPlace road = places.draw(random);
      return End{graph.lines.position(road), road, 0};
    };
    Result result;
    double longest = 0;
    const std::int64_t most_draws = 20 * params.pairs;
    std::int64_t left = params.pairs;
    for (std::int64_t k = 0; k < most_draws && left > 0; ++k) {
      context.stop_if_cancelled();
      const auto from = draw(), to = draw();
      if (!from || !to) continue;
      ++result.drawn;
      const auto geodesic = geodesics.between(from->position, to->position);
      if (!geodesic) ++result.off_free;
      if (!geodesic || *geodesic == Geodesics::kUnreachable || *geodesic < params.min_distance)
        continue;
      --left;
      const double route = from->link + graph.distances.between(from->road, to->road) + to->link;
      if (route == RoadDistances::kUnreachable) {
        ++result.apart;
        continue;
      }
      result.detours.push_back(route / *geodesic);
      if (truth) {
        const double real = true_route(from->position, to->position, *truth, geodesics);
        if (real > 0 && real < RoadDistances::kUnreachable) {
          result.true_detours.push_back(real / *geodesic);
          result.to_true.push_back(route / real);
        }
      }
      if (result.detours.back() <= longest) continue;
      longest = result.detours.back();
      result.from = from->position;
      result.to = to->position;
    }
    return result;
  }

  /// Says why figures may not mean what they seem to.
  void warn_of_doubt(const Result& result, Context& context) const {
    const auto shorter = std::count_if(result.detours.begin(), result.detours.end(),
                                       [](double detour) { return detour < 1 - 1e-3; });
    if (shorter > 0) {
      context.warn(fmt::format(
          "{} of {} routes are shorter than the shortest way through free space {} m from "
          "obstacles: the graph leaves that ground, and its detours say nothing there",
          shorter, result.detours.size(), params.min_clearance));
    }
    const std::size_t judged = result.detours.size() + result.apart;
    if (result.drawn > 0 && judged < static_cast<std::size_t>(params.pairs)) {
      context.warn(
          fmt::format("only {} of {} pairs could be judged: of {} drawn, {} have a place off free "
                      "space, the others are nearer than {} m or not joined by free space",
                      judged, params.pairs, result.drawn, result.off_free, params.min_distance));
    }
  }

  static std::optional<Vector2> draw_free(const FreeCells& cells, Random& random) {
    const auto place = static_cast<std::size_t>(random.below(cells.free.size()));
    if (!cells.free[place]) return std::nullopt;
    const auto width = static_cast<std::size_t>(cells.frame.width);
    return cells.frame.centre(
        {static_cast<std::int32_t>(place % width), static_cast<std::int32_t>(place / width)});
  }

  static End joined(const Vector2& position, const MeasuredGraph& graph, Geodesics& geodesics) {
    const auto near = graph.lines.nearest(position);
    const auto link = geodesics.between(position, near->position);
    return {position, near->place, link.value_or(RoadDistances::kUnreachable)};
  }

  double true_route(const Vector2& from, const Vector2& to, MeasuredGraph& truth,
                    Geodesics& geodesics) const {
    if (params.between == "free") {
      const End a = joined(from, truth, geodesics), b = joined(to, truth, geodesics);
      return a.link + truth.distances.between(a.road, b.road) + b.link;
    }
    return truth.distances.between(truth.lines.nearest(from)->place,
                                   truth.lines.nearest(to)->place);
  }
};

STOPE_STAGE(Detour, "metric/detour")

}  // namespace stope::metric
