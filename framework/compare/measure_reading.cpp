#include "framework/compare/measure_reading.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "framework/pipeline/sentence.hpp"

namespace stope {
namespace {

MeasureReading unusable(std::string sentence) {
  return {std::numeric_limits<double>::quiet_NaN(), std::move(sentence)};
}

std::string unit_text(const std::string& unit) {
  return unit.empty() ? "a plain number" : fmt::format("in {}", unit);
}

}  // namespace

MeasureReading read_measure(const ExperimentMetric& metric, const std::optional<Measures>& measures,
                            ComparedMetric& compared) {
  if (!measures) return unusable(fmt::format("Stage '{}' gave no measures.", compared.stage));
  const auto found = std::find(measures->names.begin(), measures->names.end(), metric.measure);
  const auto place = static_cast<std::size_t>(found - measures->names.begin());
  if (found == measures->names.end() || place >= measures->values.size())
    return unusable(
        joined(fmt::format("Stage '{}' gave no figure '{}'.", compared.stage, metric.measure),
               did_you_mean(metric.measure, measures->names,
                            fmt::format("It gave {}.", quoted_list(measures->names)))));
  const std::string unit = place < measures->units.size() ? measures->units[place] : "";
  const double value = measures->values[place];
  if (!std::isfinite(value))
    return unusable(fmt::format("The figure '{}' of stage '{}' is {}, which cannot be compared.",
                                metric.measure, compared.stage, value));
  const Conversion delta = convert(metric.smallest_that_matters, unit);
  if (!delta.value)
    return unusable(
        joined(fmt::format("The figure '{}' is {}, but the experiment says what matters "
                           "of it in {}.",
                           metric.measure, unit_text(unit), metric.smallest_that_matters.unit),
               delta.hint));
  compared.unit = unit;
  compared.smallest_that_matters = *delta.value;
  return {value, {}};
}

}  // namespace stope
