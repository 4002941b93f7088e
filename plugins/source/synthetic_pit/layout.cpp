// Planning a mine.
//
// Problem: every seed shall give another road network that could be a real mine's, and whose truth
// is known exactly. Idea: main roads are curves along the pit's shape; side roads are random
// proposals that are built only if they keep the rules (room for berms and banks, radius, grade),
// so that whatever comes out can be graded into terrain. Cost: proposals x length of the network in
// steps of 6 m; milliseconds for a pit of 500 m, a second or two for one of 4 km.
#include "plugins/source/synthetic_pit/layout.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "plugins/source/synthetic_pit/curve.hpp"
#include "plugins/source/synthetic_pit/main_roads.hpp"
#include "plugins/source/synthetic_pit/side_roads.hpp"
#include "stope/error.hpp"

namespace stope::source {
namespace {

constexpr double kPi = std::numbers::pi;
// Metres, of a turning place: the corners of a 9 x 4 m truck that turns on 12 m reach 15 m.
constexpr double kSmallestPlace = 15;

class Planner {
 public:
  Planner(const PitParameters& parameters, std::uint64_t seed, const Checkpoint& checkpoint)
      : parameters_(parameters),
        checkpoint_(checkpoint),
        random_(mix_seed(seed, 10)),
        layout_{PitShape(parameters, seed), {}, rules_of(parameters)} {}

  Layout plan() {
    main_roads();
    const std::int64_t wanted = parameters_.dead_ends;
    const std::int64_t below = layout_.shape.yard() ? wanted : (wanted + 1) / 3;
    bench_faces(layout_.shape.yard() ? 0 : wanted / 4);
    floor_faces(below);
    connectors();
    surface_ends(wanted);
    stockpiles();
    return std::move(layout_);
  }

 private:
  static NetworkRules rules_of(const PitParameters& parameters) {
    NetworkRules rules;
    rules.half_size = 0.5 * parameters.size;
    rules.grade = parameters.grade;
    rules.smallest_radius = std::max(15.0, 0.5 * parameters.road_width + rules.fillet);
    return rules;
  }

  bool accept(Proposal proposal) {
    checkpoint_();
    if (!buildable(layout_.network, proposal, layout_.rules)) return false;
    build(layout_.network, std::move(proposal));
    return true;
  }

  std::int64_t dead_ends() const {
    return static_cast<std::int64_t>(layout_.network.dead_ends.size());
  }

  void main_roads() {
    const std::size_t loop = 0, ring = 1;
    build(layout_.network, {floor_loop(layout_.shape, parameters_), {}, {}, {}});
    if (layout_.shape.yard()) return;
    build(layout_.network, {ring_road(layout_.shape, parameters_), {}, {}, {}});
    const bool like_two = random_.uniform() < 0.85;
    const bool like_switchback = random_.uniform() < 0.4;
    const double turn = random_.uniform() < 0.5 ? 1 : -1;
    const double first_angle = random_.uniform(0, 2 * kPi);
    for (int attempt = 0; attempt < 120 && ramps_.empty(); ++attempt) {
      RampPlan plan;
      plan.angle = first_angle + 0.5 * attempt;
      plan.turn = turn;
      plan.switchback = like_switchback && attempt < 24;
      plan.grade = parameters_.grade * random_.uniform(0.84, 0.96);
      add_ramp(ring, loop, plan);
    }
    if (ramps_.empty())
      throw Error(fmt::format(
          "no ramp of {:.0f} m depth, {:.0f} m width and a grade of {:.0f} % fits into a mine of "
          "{:.0f} m: use a larger size, fewer or lower benches, a narrower road or a steeper grade",
          layout_.shape.depth(), parameters_.road_width, 100 * parameters_.grade,
          parameters_.size));
    for (int attempt = 0; attempt < 150 && like_two && ramps_.size() == 1; ++attempt) {
      RampPlan plan;
      plan.angle = random_.uniform(0, 2 * kPi);
      plan.turn = random_.uniform() < 0.5 ? 1 : -1;
      plan.grade = parameters_.grade * random_.uniform(0.88, 0.97);
      add_ramp(ring, loop, plan);
    }
  }

  void add_ramp(std::size_t ring, std::size_t loop, const RampPlan& plan) {
    checkpoint_();
    std::optional<Ramp> ramp = ramp_road(layout_, parameters_, ring, loop, plan);
    if (!ramp || !accept(ramp->proposal)) return;
    ramps_.push_back({layout_.network.streets.size() - 1, ramp->landings});
  }

  DeadEnd turning_place(DeadEndKind kind) {
    DeadEnd end;
    end.kind = kind;
    const double least =
        std::max(kSmallestPlace + parameters_.rough, 0.5 * parameters_.road_width + 5);
    const bool open = kind != DeadEndKind::kLoadingFace && !layout_.shape.yard();
    end.radius = least + (layout_.shape.yard() ? 0.0 : random_.uniform(2, open ? 12 : 7));
    return end;
  }

  void bench_faces(std::int64_t wanted) {
    for (const auto& [street, landings] : ramps_) {
      for (const double landing : landings) {
        const Street& ramp = layout_.network.streets[street];
        const auto point = static_cast<std::size_t>(
            std::lower_bound(ramp.station.begin(), ramp.station.end(), landing) -
            ramp.station.begin());
        for (int attempt = 0; attempt < 40 && dead_ends() < wanted; ++attempt) {
          SideRoadPlan plan{street, point};
          plan.side = attempt % 2 == 0 ? 1 : -1;
          plan.length = random_.uniform(70, 190);
          plan.lean = random_.uniform(-2.2, 2.2);
          plan.wobble = 0.1;
          if (accept(side_road(layout_, plan, turning_place(DeadEndKind::kLoadingFace), random_)))
            break;
        }
      }
    }
  }

  void floor_faces(std::int64_t wanted) {
    const std::int64_t before = dead_ends();
    for (std::int64_t attempt = 0; attempt < 100 + 40 * wanted && dead_ends() < before + wanted;
         ++attempt) {
      SideRoadPlan plan{0, random_.below(layout_.network.streets[0].points.size())};
      plan.side = random_.uniform() < 0.75 ? -1 : 1;  // the loop runs counter-clockwise
      const double scale =
          layout_.shape.yard() ? 0.5 : std::clamp(parameters_.size / 500, 0.8, 4.0);
      plan.length = scale * random_.uniform(60, 110);
      plan.lean = random_.uniform(-1.2, 1.2);
      accept(side_road(layout_, plan, turning_place(DeadEndKind::kLoadingFace), random_));
    }
  }

  void connectors() {
    std::int64_t built = 0;
    for (std::int64_t attempt = 0;
         attempt < 60 + 40 * parameters_.connectors && built < parameters_.connectors; ++attempt) {
      const bool surface = !layout_.shape.yard() && random_.uniform() < 0.7;
      const std::size_t number = surface ? 1 : 0;
      const Street& street = layout_.network.streets[number];
      const std::size_t count = street.points.size();
      SideRoadPlan from{number, random_.below(count)}, to{number, 0};
      const double scale = std::clamp(parameters_.size / 500, 0.8, 5.0);
      const double gap =
          surface ? scale * random_.uniform(90, 260) : random_.uniform(0.3, 0.5) * street.length();
      to.point = (from.point + static_cast<std::size_t>(gap / kStreetStep)) % count;
      from.side = to.side = surface ? -1 : 1;
      from.lean = surface ? -random_.uniform(0.1, 0.5) : 0.0;
      from.wobble = surface ? 0.0 : 0.15;
      Proposal proposal = connecting_road(layout_, from, to, random_);
      if (surface) follow_surface(proposal.street);
      built += accept(std::move(proposal)) ? 1 : 0;
    }
  }

  void follow_surface(Street& street) const {
    for (std::size_t i = 0; i < street.points.size(); ++i)
      street.elevation[i] = layout_.shape.surface(street.points[i]);
  }

  /// Climbs to the top of a dump: level at the start and for the turning place, even between.
  void climb(Street& street, const DeadEnd& end, double height) const {
    const double start = street.elevation.front();
    const double slope = street.length() - 30 - end.radius - 12;
    for (std::size_t i = 0; i < street.points.size(); ++i)
      street.elevation[i] = start + height * std::clamp((street.station[i] - 30) / slope, 0.0, 1.0);
    street.elevation = moving_average(street.elevation, 6);
  }

  void surface_ends(std::int64_t wanted) {
    if (layout_.shape.yard()) return;
    for (std::int64_t attempt = 0; attempt < 300 + 120 * wanted && dead_ends() < wanted;
         ++attempt) {
      const bool dump = dead_ends() % 2 == 0;
      const double scale = std::clamp(parameters_.size / 500, 0.8, 4.0);
      // From the ring, or from anything built on the surface since.
      std::size_t through = 1;
      if (random_.uniform() < 0.35) through = random_.below(layout_.network.streets.size());
      const Street& street = layout_.network.streets[through];
      SideRoadPlan plan{through, random_.below(street.points.size())};
      if (street.elevation[plan.point] < -2 || street.elevation[plan.point] > 2) continue;
      plan.side = through == 1 || random_.uniform() < 0.5 ? -1 : 1;
      plan.length = scale * (dump ? random_.uniform(100, 220) : random_.uniform(55, 130));
      plan.lean = random_.uniform(-2.0, 2.0);
      const DeadEnd end = turning_place(dump ? DeadEndKind::kDump : DeadEndKind::kYard);
      Proposal proposal = side_road(layout_, plan, end, random_);
      double height = 0;
      if (dump) {
        height = 0.85 * parameters_.grade * (proposal.street.length() - 42 - end.radius);
        if (height < 3) continue;
        climb(proposal.street, end, std::min(height, 2.5 * parameters_.bench_height));
      } else {
        follow_surface(proposal.street);
        level_end(proposal.street, end);
      }
      const Vector2 place = proposal.street.points.back();
      const double top = proposal.street.elevation.back();
      if (accept(std::move(proposal)) && dump)
        layout_.shape.add({place, end.radius + random_.uniform(8, 22), top, -4});
    }
  }

  static void level_end(Street& street, const DeadEnd& end) {
    const double from = street.length() - end.radius - 4;
    double level = street.elevation.back();
    for (std::size_t i = 0; i < street.points.size(); ++i) {
      if (street.station[i] < from)
        level = street.elevation[i];
      else
        street.elevation[i] = level;
    }
  }

  bool clear_of_roads(const Vector2& place, double radius) const {
    for (const Street& street : layout_.network.streets) {
      for (const Vector2& point : street.points) {
        if ((point - place).norm() < radius + street.half_width() + layout_.rules.berm_width)
          return false;
      }
    }
    for (const DeadEnd& end : layout_.network.dead_ends) {
      const double room = radius + end.radius + layout_.rules.berm_width;
      if ((layout_.network.centre(end) - place).norm() < room) return false;
    }
    return true;
  }

  void stockpiles() {
    for (const DeadEnd& end : std::vector<DeadEnd>(layout_.network.dead_ends)) {
      checkpoint_();
      if (end.kind == DeadEndKind::kDump) continue;
      for (int attempt = 0; attempt < 14; ++attempt) {
        const double height = random_.uniform(3, 8), radius = height / 0.75;
        const double angle = random_.uniform(0, 2 * kPi);
        const double distance =
            end.radius + layout_.rules.berm_width + radius + random_.uniform(0, 14);
        const Vector2 place =
            layout_.network.centre(end) + distance * Vector2(std::cos(angle), std::sin(angle));
        const double ground = layout_.shape.ground(place);
        // On the flat around the place only: nobody tips over a bench's edge.
        if (std::abs(ground - layout_.network.elevation(end)) < 2 && clear_of_roads(place, radius))
          layout_.shape.add({place, 0, ground + height, ground - 4});
      }
    }
  }

  struct BuiltRamp {
    std::size_t street;
    std::vector<double> landings;
  };

  const PitParameters& parameters_;
  const Checkpoint& checkpoint_;
  Random random_;
  Layout layout_;
  std::vector<BuiltRamp> ramps_;
};

}  // namespace

Layout plan_layout(const PitParameters& parameters, std::uint64_t seed,
                   const Checkpoint& checkpoint) {
  return Planner(parameters, seed, checkpoint).plan();
}

}  // namespace stope::source
