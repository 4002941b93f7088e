// Problem: a road graph has only the roads its extractor found; across open ground there are
// others. Idea: sampling planners of OMPL (Kavraki et al. 1996; Gammell et al. 2020) look for them
// in the free ground around the roads; what they find is added as roads, so that closed and one-way
// roads, costs and refusals stay those of the one search that all planners here share. Each planner
// is driven step by step: PRM::solve would start a thread and look at the clock, and OMPL's
// generators are seeded by a counter that all planners of a process share. Cost: PRM O((n +
// samples)^2) with its linear search for neighbours; BIT* likewise a batch.
#include "plugins/planner/sampled_roads.hpp"

#include <ompl/base/objectives/PathLengthOptimizationObjective.h>
#include <ompl/base/samplers/InformedStateSampler.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/datastructures/NearestNeighborsLinear.h>
#include <ompl/geometric/PathGeometric.h>
#include <ompl/geometric/planners/informedtrees/BITstar.h>
#include <ompl/geometric/planners/prm/PRM.h>
#include <ompl/util/Console.h>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace stope::planner {
namespace {

namespace ob = ompl::base;
namespace og = ompl::geometric;
using Plane = ob::RealVectorStateSpace;

Vector2 point_of(const ob::State* state) {
  const auto* plane = state->as<Plane::StateType>();
  return {plane->values[0], plane->values[1]};
}

class SteppedPrm final : public og::PRM {
 public:
  SteppedPrm(const ob::SpaceInformationPtr& space, std::uint32_t neighbours) : PRM(space) {
    setProblemDefinition(std::make_shared<ob::ProblemDefinition>(space));
    // The default structure picks its pivots with a generator that cannot be seeded.
    setNearestNeighbors<ompl::NearestNeighborsLinear>();
    // PRM gives its distance only to a structure it made itself.
    nn_->setDistanceFunction([this](Vertex a, Vertex b) { return distanceFunction(a, b); });
    setup();
    setMaxNearestNeighbors(neighbours);
  }
  void add(const Vector2& point) {
    ob::State* state = si_->allocState();
    state->as<Plane::StateType>()->values[0] = point.x();
    state->as<Plane::StateType>()->values[1] = point.y();
    addMilestone(state);
  }
};

/// Draws from a list first, then at random, only what can be on a better way than the best so far.
class ListedSampler final : public ob::InformedSampler {
 public:
  ListedSampler(const ob::ProblemDefinitionPtr& problem, unsigned int most,
                const std::vector<Vector2>& listed, const std::function<void(double*)>& draw,
                std::size_t& next)
      : InformedSampler(problem, most), listed_(listed), draw_(draw), next_(next) {}
  bool sampleUniform(ob::State* state, const ob::Cost& most) override {
    return sampleUniform(state, ob::Cost(-1), most);
  }
  bool sampleUniform(ob::State* state, const ob::Cost& least, const ob::Cost& most) override {
    double* values = state->as<Plane::StateType>()->values;
    for (unsigned int i = 0; i < numIters_; ++i) {
      if (next_ < listed_.size()) {
        values[0] = listed_[next_].x(), values[1] = listed_[next_].y();
        ++next_;
      } else {
        draw_(values);
        space_->enforceBounds(state);
      }
      const ob::Cost through = heuristicSolnCost(state);
      if (opt_->isCostBetterThan(through, most) && !opt_->isCostBetterThan(through, least))
        return true;
    }
    return false;
  }
  bool hasInformedMeasure() const override { return false; }
  double getInformedMeasure(const ob::Cost&) const override { return space_->getMeasure(); }

 private:
  const std::vector<Vector2>& listed_;
  const std::function<void(double*)>& draw_;
  std::size_t& next_;
};

class Shortest final : public ob::PathLengthOptimizationObjective {
 public:
  Shortest(const ob::SpaceInformationPtr& space, const std::vector<Vector2>& listed,
           std::function<void(double*)> draw)
      : PathLengthOptimizationObjective(space), listed_(listed), draw_(std::move(draw)) {}
  ob::InformedSamplerPtr allocInformedStateSampler(const ob::ProblemDefinitionPtr& problem,
                                                   unsigned int most) const override {
    return std::make_shared<ListedSampler>(problem, most, listed_, draw_, next_);
  }

 private:
  const std::vector<Vector2>& listed_;
  std::function<void(double*)> draw_;
  mutable std::size_t next_ = 0;
};

void add_line(RoadGraph& roads, std::uint32_t from, std::uint32_t to,
              const std::vector<Vector2>& points, const FreeGround& ground) {
  constexpr double kStep = 2;  // metres: clearance is linear between vertices
  RoadEdge edge;
  edge.from = from, edge.to = to;
  edge.first_vertex = static_cast<std::uint32_t>(roads.vertices.size());
  edge.min_clearance = HUGE_VAL;
  const double z_from = roads.nodes[from].z, z_to = roads.nodes[to].z;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vector2 a = points[i], b = points[std::min(i + 1, points.size() - 1)];
    const double steps = std::max(1.0, std::ceil((b - a).norm() / kStep));
    for (double k = 0; k < (i + 1 < points.size() ? steps : 1); ++k) {
      const Vector2 at = a + (k / steps) * (b - a);
      const double f = (i + k / steps) / static_cast<double>(points.size() - 1);
      const double clearance = ground.clearance(at);
      roads.vertices.push_back({at.x(), at.y(), z_from + f * (z_to - z_from), clearance});
      edge.min_clearance = std::min(edge.min_clearance, clearance);
    }
    edge.length += (b - a).norm();
  }
  edge.vertex_count = static_cast<std::uint32_t>(roads.vertices.size()) - edge.first_vertex;
  edge.mean_clearance = edge.min_clearance;
  roads.edges.push_back(edge);
}

}  // namespace

void add_prm_roads(RoadGraph& roads, const FreeGround& ground, const RoadNetwork& network,
                   std::uint32_t samples, std::uint32_t neighbours, std::uint64_t seed) {
  ompl::msg::setLogLevel(ompl::msg::LOG_NONE);  // the run's log is not OMPL's
  Random random(seed);
  const auto draw = [&](double* xy) { ground.draw(random, xy); };
  const auto space = ground.space(draw);
  SteppedPrm prm(space, neighbours);
  std::vector<std::uint32_t> nodes;  // of each milestone
  for (std::uint32_t node = 0; node < roads.nodes.size(); ++node) {
    const Vector2 point(roads.nodes[node].x, roads.nodes[node].y);
    if (network.arcs_from(node).empty() || !ground.valid(point)) continue;
    prm.add(point);
    nodes.push_back(node);
  }
  if (nodes.empty()) return;
  for (std::uint32_t i = 0; i < samples; ++i) {
    Vector2 point;
    ground.draw(random, point.data());
    if (!ground.valid(point)) continue;
    prm.add(point);
    nodes.push_back(static_cast<std::uint32_t>(roads.nodes.size()));
    roads.nodes.push_back({0, point.x(), point.y(), ground.height(point)});
  }
  const auto& found = prm.getRoadmap();
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
  for (auto [edge, end] = boost::edges(found); edge != end; ++edge) {
    const auto a = static_cast<std::uint32_t>(boost::source(*edge, found));
    const auto b = static_cast<std::uint32_t>(boost::target(*edge, found));
    pairs.emplace_back(std::min(nodes[a], nodes[b]), std::max(nodes[a], nodes[b]));
  }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  for (const auto& [from, to] : pairs) {
    const RoadNode &a = roads.nodes[from], &b = roads.nodes[to];
    add_line(roads, from, to, {Vector2(a.x, a.y), Vector2(b.x, b.y)}, ground);
  }
}

std::optional<std::vector<Vector2>> bit_star_way(const FreeGround& ground,
                                                 const RoadNetwork& network, const Vector2& start,
                                                 const Vector2& goal, std::uint32_t iterations,
                                                 std::uint32_t batch, std::uint64_t seed) {
  if (!ground.valid(start) || !ground.valid(goal) || start == goal) return std::nullopt;
  ompl::msg::setLogLevel(ompl::msg::LOG_NONE);
  Random random(seed);
  std::function<void(double*)> draw = [&](double* xy) { ground.draw(random, xy); };
  const auto space = ground.space(draw);
  std::vector<Vector2> listed;
  const RoadGraph& graph = network.graph();
  for (std::uint32_t e = 0; e < graph.edges.size(); ++e) {
    if (!network.usable(e)) continue;
    for (const RoadVertex& vertex : graph.polyline(graph.edges[e]))
      listed.emplace_back(vertex.x, vertex.y);
  }
  auto problem = std::make_shared<ob::ProblemDefinition>(space);
  ob::ScopedState<Plane> from(space), to(space);
  from->values[0] = start.x(), from->values[1] = start.y();
  to->values[0] = goal.x(), to->values[1] = goal.y();
  problem->setStartAndGoalStates(from, to);
  problem->setOptimizationObjective(std::make_shared<Shortest>(space, listed, draw));
  og::BITstar planner(space);
  planner.setSamplesPerBatch(batch);
  planner.setProblemDefinition(problem);
  planner.setup();
  std::uint32_t asked = 0;
  planner.solve(ob::PlannerTerminationCondition([&] { return ++asked > iterations; }));
  if (!problem->hasExactSolution()) return std::nullopt;
  const auto* path = problem->getSolutionPath()->as<og::PathGeometric>();
  std::vector<Vector2> way;
  for (std::size_t i = 0; i < path->getStateCount(); ++i)
    way.push_back(point_of(path->getState(static_cast<unsigned>(i))));
  return way.size() < 2 ? std::nullopt : std::optional(way);
}

void add_way(RoadGraph& roads, const std::vector<Vector2>& way, const FreeGround& ground) {
  const auto from = static_cast<std::uint32_t>(roads.nodes.size());
  for (const Vector2& end : {way.front(), way.back()})
    roads.nodes.push_back({0, end.x(), end.y(), ground.height(end)});
  add_line(roads, from, from + 1, way, ground);
}

}  // namespace stope::planner
