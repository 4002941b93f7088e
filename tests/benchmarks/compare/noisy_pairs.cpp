#include "noisy_pairs.hpp"

#include <cmath>
#include <numbers>
#include <string>

namespace stope::testing {
namespace {

// exp of a normal has mean sqrt(e) and variance e (e - 1).
double skewed(Random& random) {
  constexpr double e = std::numbers::e;
  return (std::exp(random.normal()) - std::sqrt(e)) / std::sqrt(e * (e - 1));
}

double student(Random& random) {
  double squares = 0;
  for (int i = 0; i < 3; ++i) squares += std::pow(random.normal(), 2);
  // Its variance is 3.
  return random.normal() / std::sqrt(squares / 3) / std::sqrt(3.0);
}

/// Of mean 0 and deviation 1; `scale` is the recording's.
double stray(Noise noise, double scale, Random& random) {
  switch (noise) {
    case Noise::kNormal:
      return random.normal();
    case Noise::kSkewed:
      return skewed(random);
    case Noise::kHeavy:
      return student(random);
    case Noise::kDiscrete:
      return (static_cast<double>(random.below(3)) - 1) / std::sqrt(2.0 / 3);
    case Noise::kHeteroscedastic:
      // exp of a normal has mean square e^2.
      return scale / std::numbers::e * random.normal();
  }
  return 0;
}

}  // namespace

std::string_view name_of(Noise noise) {
  constexpr std::array<std::string_view, 5> names{"normal", "skewed", "heavy tails", "discrete",
                                                  "heteroscedastic"};
  return names[static_cast<std::size_t>(noise)];
}

std::vector<MeasuredPairs> drawn_pairs(const Drawn& drawn, Random& random) {
  std::vector<MeasuredPairs> all;
  for (int measure = 0; measure < drawn.measures; ++measure) {
    all.push_back({"measure " + std::to_string(measure), Direction::kHigher, drawn.delta, {}, {}});
    const double difference = measure == 0 ? drawn.difference : 0;
    for (int recording = 0; recording < drawn.recordings; ++recording) {
      const double truth = std::round(random.uniform(20, 60)), scale = std::exp(random.normal());
      const auto mean_of_runs = [&] {
        double sum = 0;
        for (int seed = 0; seed < drawn.seeds; ++seed) sum += stray(drawn.noise, scale, random);
        return sum / drawn.seeds;
      };
      // The difference of two runs has the deviation sqrt(2).
      const double baseline = truth + mean_of_runs() / std::numbers::sqrt2;
      const double arm = truth + mean_of_runs() / std::numbers::sqrt2 + difference;
      all.back().pairs.push_back({"recording " + std::to_string(recording), baseline, arm});
    }
  }
  return all;
}

std::vector<double> skewed_differences(int recordings, Random& random) {
  std::vector<double> differences(static_cast<std::size_t>(recordings));
  for (double& difference : differences) difference = skewed(random);
  return differences;
}

}  // namespace stope::testing
