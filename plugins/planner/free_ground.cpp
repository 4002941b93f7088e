#include "plugins/planner/free_ground.hpp"

#include <ompl/base/MotionValidator.h>
#include <ompl/base/StateSampler.h>
#include <ompl/base/StateValidityChecker.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "plugins/planner/road_snap.hpp"

namespace stope::planner {
namespace {

namespace ob = ompl::base;
using Plane = ob::RealVectorStateSpace;

constexpr double kFarthest = 20;  // metres: beyond it clearance does not matter

Vector2 point_of(const ob::State* state) {
  const auto* plane = state->as<Plane::StateType>();
  return {plane->values[0], plane->values[1]};
}

class Sampler final : public ob::StateSampler {
 public:
  Sampler(const ob::StateSpace* space, std::function<void(double*)> draw)
      : StateSampler(space), draw_(std::move(draw)) {}
  void sampleUniform(ob::State* state) override {
    draw_(state->as<Plane::StateType>()->values);
    space_->enforceBounds(state);
  }
  // Nobody here asks for samples near a state.
  void sampleUniformNear(ob::State* state, const ob::State*, double) override {
    sampleUniform(state);
  }
  void sampleGaussian(ob::State* state, const ob::State*, double) override { sampleUniform(state); }

 private:
  std::function<void(double*)> draw_;
};

class Validity final : public ob::StateValidityChecker {
 public:
  Validity(const ob::SpaceInformationPtr& space, const FreeGround& ground)
      : StateValidityChecker(space), ground_(ground) {}
  bool isValid(const ob::State* state) const override { return ground_.valid(point_of(state)); }

 private:
  const FreeGround& ground_;
};

class Motions final : public ob::MotionValidator {
 public:
  Motions(const ob::SpaceInformationPtr& space, const FreeGround& ground)
      : MotionValidator(space), ground_(ground) {}
  bool checkMotion(const ob::State* a, const ob::State* b) const override {
    return ground_.sees(point_of(a), point_of(b));
  }
  bool checkMotion(const ob::State* a, const ob::State* b,
                   std::pair<ob::State*, double>& last) const override {
    const bool valid = checkMotion(a, b);
    if (!valid) {
      last.second = 0;
      if (last.first) si_->copyState(last.first, a);
    }
    return valid;
  }

 private:
  const FreeGround& ground_;
};

}  // namespace

FreeGround::FreeGround(const DrivableGrid& grid, const RoadNetwork& network,
                       const RequestedChanges& requested, double snap_distance)
    : grid_(grid), network_(network), forbidden_(grid.frame().size(), false) {
  const RoadChanges changes = resolve(requested, network, snap_distance);
  const GridFrame& frame = grid.frame();
  const auto& edges = network.graph().edges;
  double whole = 0;
  for (std::uint32_t e = 0; e < edges.size(); ++e) {
    const double length = network.length(e);
    const bool open = network.forward(e) && network.backward(e) && changes.all().count(e) == 0;
    if (open) {
      whole += length;
      stretches_.push_back({e, whole});
      continue;
    }
    const double steps = std::ceil(length / frame.resolution);
    for (double i = 0; i <= steps; ++i) {
      const RoadVertex at = network.at({e, steps > 0 ? length * i / steps : 0});
      const Vector2 centre = frame.to_grid(at.x, at.y);
      const double radius =
          std::clamp(std::isfinite(at.clearance) ? at.clearance : 0, 0.0, kFarthest) /
              frame.resolution +
          1;
      const auto low = [&](double value) { return static_cast<std::int32_t>(value - radius); };
      const auto high = [&](double value) { return static_cast<std::int32_t>(value + radius); };
      for (std::int32_t row = low(centre.y()); row <= high(centre.y()); ++row) {
        for (std::int32_t column = low(centre.x()); column <= high(centre.x()); ++column) {
          if (frame.contains({column, row}) &&
              (Vector2(column + 0.5, row + 0.5) - centre).norm() <= radius)
            forbidden_[frame.place({column, row})] = true;
        }
      }
    }
  }
}

ob::SpaceInformationPtr FreeGround::space(std::function<void(double* xy)> draw) const {
  const GridFrame& frame = grid_.frame();
  ob::RealVectorBounds bounds(2);
  for (int axis = 0; axis < 2; ++axis) {
    double low = HUGE_VAL, high = -HUGE_VAL;
    for (const double column : {0, frame.width}) {
      for (const double row : {0, frame.height}) {
        const double value = frame.to_map(column, row)[axis];
        low = std::min(low, value), high = std::max(high, value);
      }
    }
    bounds.setLow(static_cast<unsigned>(axis), low);
    bounds.setHigh(static_cast<unsigned>(axis), high);
  }
  auto plane = std::make_shared<Plane>(2);
  plane->setBounds(bounds);
  plane->setStateSamplerAllocator([draw = std::move(draw)](const ob::StateSpace* space) {
    return std::make_shared<Sampler>(space, draw);
  });
  auto information = std::make_shared<ob::SpaceInformation>(plane);
  information->setStateValidityChecker(std::make_shared<Validity>(information, *this));
  information->setMotionValidator(std::make_shared<Motions>(information, *this));
  information->setup();
  return information;
}

void FreeGround::draw(Random& random, double* xy) const {
  Vector2 point = Vector2::Zero();
  if (!stretches_.empty()) {
    const double at = random.uniform() * stretches_.back().until;
    const auto found = std::lower_bound(
        stretches_.begin(), stretches_.end(), at,
        [](const Stretch& stretch, double value) { return stretch.until < value; });
    const Stretch& stretch = found == stretches_.end() ? stretches_.back() : *found;
    const double length = network_.length(stretch.edge);
    const RoadVertex vertex =
        network_.at({stretch.edge, std::clamp(length - (stretch.until - at), 0.0, length)});
    const double clearance = std::isfinite(vertex.clearance) ? vertex.clearance : 0;
    const double radius = std::clamp(clearance, 0.0, kFarthest) * std::sqrt(random.uniform());
    const double angle = 2 * std::numbers::pi * random.uniform();
    point = {vertex.x + radius * std::cos(angle), vertex.y + radius * std::sin(angle)};
  }
  xy[0] = point.x();
  xy[1] = point.y();
}

bool FreeGround::valid(const Vector2& point) const {
  const auto cell = grid_.frame().cell_at(point.x(), point.y());
  if (!cell || !grid_.free(*cell) || forbidden_[grid_.frame().place(*cell)]) return false;
  const double wanted = network_.rules().min_clearance;
  return wanted <= 0 || grid_.clearance(point, wanted) >= wanted;
}

bool FreeGround::sees(const Vector2& a, const Vector2& b) const {
  if (!grid_.line_free(a, b)) return false;
  const double steps = std::ceil((b - a).norm() / (0.5 * grid_.frame().resolution));
  for (double i = 0; i <= steps; ++i)
    if (!valid(steps > 0 ? Vector2(a + (i / steps) * (b - a)) : a)) return false;
  return true;
}

double FreeGround::clearance(const Vector2& point) const {
  return grid_.clearance(point, kFarthest);
}

double FreeGround::height(const Vector2& point) const {
  const auto places = nearest_places(network_, point, [](std::uint32_t) { return true; });
  return places.empty() ? std::nan("") : network_.at(places.front().place).z;
}

}  // namespace stope::planner
