#include "plugins/source/synthetic_pit/pit_shape.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "plugins/source/synthetic_pit/noise.hpp"
#include "stope/random.hpp"

namespace stope::source {
namespace {

constexpr double kWallSlope = 2.6;     // rise over run of a blasted wall, 69 degrees
constexpr double kReposeSlope = 0.75;  // of tipped rock, 37 degrees
constexpr double kBund = 0.9;          // height of the bund along a bench's crest
constexpr int kWaves = 5;
constexpr std::size_t kRimSamples = 8192;
constexpr double kWander = 2.2;        // metres a wall's line strays
constexpr double kSmallestMine = 300;  // metres: below it there is no room for a ramp

}  // namespace

PitShape::PitShape(const PitParameters& parameters, std::uint64_t seed)
    : seed_(seed),
      benches_(parameters.benches),
      bench_height_(parameters.bench_height),
      bench_width_(0.7 * parameters.bench_height),
      yard_(parameters.size < kSmallestMine) {
  Random random(mix_seed(seed, 1));
  const double size = parameters.size;
  // The larger the mine, the more of it is benches wide enough to work on.
  const double share = std::clamp((size - 300) / 2000, 0.0, 1.0);
  if (!yard_) {
    const double room = (0.085 + 0.1 * share) * size / static_cast<double>(benches_);
    bench_width_ = std::clamp(room - wall_run(), bench_width_, 60.0);
  }
  radius_ = yard_ ? 0.35 * size + inward(depth()) : (0.285 + 0.04 * share) * size;
  const double shift = yard_ ? 0.0 : 0.05 * size;
  const double direction = random.uniform(0, 2 * std::numbers::pi);
  squares_ = static_cast<std::int32_t>(std::ceil(size / kSquare)) + 1;
  heaps_.resize(static_cast<std::size_t>(squares_) * static_cast<std::size_t>(squares_));
  centre_ = Vector2(shift * std::cos(direction), shift * std::sin(direction));
  std::array<double, kWaves> amplitude{}, phase{};
  for (int i = 0; i < kWaves; ++i) {
    // Low waves make the pit longer than wide and kidney-shaped, high ones make corners.
    const double size_of_wave = yard_ ? 0.03 : (i == 0 ? 0.12 : 0.07 / (i + 1));
    amplitude[i] = size_of_wave * random.uniform(0.5, 1.0);
    phase[i] = random.uniform(0, 2 * std::numbers::pi);
  }
  for (std::size_t k = 0; k <= kRimSamples; ++k) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(k) / kRimSamples;
    double factor = 1;
    for (int i = 0; i < kWaves; ++i) factor += amplitude[i] * std::cos((i + 2) * angle + phase[i]);
    rim_.push_back(radius_ * factor);
  }
}

std::size_t PitShape::square(double x, double y) const {
  const auto index = [&](double v) {
    const double middle = 0.5 * squares_;
    return static_cast<std::size_t>(std::clamp(v / kSquare + middle, 0.0, squares_ - 1.0));
  };
  return index(y) * static_cast<std::size_t>(squares_) + index(x);
}

void PitShape::add(const Heap& heap) {
  const double reach = heap.top_radius + (heap.top - heap.base) / kReposeSlope + kWander;
  const double step = 0.5 * kSquare;
  std::size_t last = heaps_.size();
  for (double y = heap.centre.y() - reach; y < heap.centre.y() + reach + step; y += step) {
    for (double x = heap.centre.x() - reach; x < heap.centre.x() + reach + step; x += step) {
      const std::size_t here = square(x, y);
      auto& heaps = heaps_[here];
      if (here == last || (!heaps.empty() && heaps.back().centre == heap.centre)) continue;
      heaps.push_back(heap);
      last = here;
    }
  }
}

double PitShape::wall_run() const { return bench_height_ / kWallSlope; }
double PitShape::bench_run() const { return wall_run() + bench_width_; }

double PitShape::rim(double angle) const {
  const double turns = angle / (2 * std::numbers::pi);
  const double place = (turns - std::floor(turns)) * kRimSamples;
  const auto before = std::min<std::size_t>(static_cast<std::size_t>(place), kRimSamples - 1);
  const double t = place - static_cast<double>(before);
  return (1 - t) * rim_[before] + t * rim_[before + 1];
}

Vector2 PitShape::at(double angle, double outward) const {
  const double distance = rim(angle) + outward;
  return centre_ + Vector2(distance * std::cos(angle), distance * std::sin(angle));
}

double PitShape::surface(const Vector2& place) const {
  return 1.5 * value_noise(mix_seed(seed_, 2), place.x() / 180, place.y() / 180);
}

double PitShape::step_depth(double inside) const {
  if (inside <= 0) return 0;
  const auto bench = static_cast<std::int64_t>(inside / bench_run());
  if (bench >= benches_) return depth();
  const double rest = inside - static_cast<double>(bench) * bench_run();
  const double wall = std::min(1.0, rest / wall_run());
  double level = (static_cast<double>(bench) + wall) * bench_height_;
  const double to_crest = bench_run() - rest;
  if (bench + 1 < benches_ && to_crest < 2.4) level -= kBund * (1 - std::abs(to_crest / 1.2 - 1));
  return level;
}

double PitShape::ground(const Vector2& place) const {
  const Vector2 offset = place - centre_;
  // Walls are blasted, not machined: their lines wander.
  const double wander = kWander * fractal_noise(mix_seed(seed_, 3), place.x() / 24, place.y() / 24);
  const double inside = rim(std::atan2(offset.y(), offset.x())) - offset.norm() + wander;
  const double fade = std::clamp(1 - inside / 30, 0.0, 1.0);
  double level = fade * surface(place) - step_depth(inside);
  for (const Heap& heap : heaps_[square(place.x(), place.y())]) {
    const double distance = (place - heap.centre).norm() + 0.6 * wander;
    level = std::max(level, heap.top - kReposeSlope * std::max(0.0, distance - heap.top_radius));
  }
  return level;
}

}  // namespace stope::source
