#include "framework/compare/measure_reading.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "framework/compare/experiment/codes.hpp"
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

Figure find_figure(const ExperimentMetric& metric, const Measures& measures,
                   const std::string& stage) {
  Figure figure;
  const auto found = std::find(measures.names.begin(), measures.names.end(), metric.measure);
  const auto place = static_cast<std::size_t>(found - measures.names.begin());
  if (found == measures.names.end() || place >= measures.values.size()) {
    figure.wrong = code::kUnknownFigure;
    figure.sentence = fmt::format("Stage '{}' gave no figure '{}'.", stage, shown(metric.measure));
    figure.hint = did_you_mean(metric.measure, measures.names,
                               measures.names.empty()
                                   ? "It gave none at all."
                                   : fmt::format("It gave {}.", quoted_list(measures.names)));
    return figure;
  }
  figure.value = measures.values[place];
  if (place < measures.units.size()) figure.unit = measures.units[place];
  const Conversion delta = convert(metric.smallest_that_matters, figure.unit);
  if (delta.value) {
    figure.smallest_that_matters = *delta.value;
  } else {
    figure.wrong = code::kWrongUnitOfMatters;
    figure.sentence =
        fmt::format("The figure '{}' is {}, but the experiment says what matters of it in {}.",
                    metric.measure, unit_text(figure.unit), metric.smallest_that_matters.unit);
    figure.hint = !delta.hint.empty()   ? delta.hint
                  : figure.unit.empty() ? "Write it without a unit."
                                        : fmt::format("Write it in {}.", figure.unit);
  }
  return figure;
}

MeasureReading read_measure(const ExperimentMetric& metric, const std::optional<Measures>& measures,
                            ComparedMetric& compared) {
  if (!measures) return unusable(fmt::format("Stage '{}' gave no measures.", compared.stage));
  const Figure figure = find_figure(metric, *measures, compared.stage);
  if (figure.wrong) return unusable(joined(figure.sentence, figure.hint));
  compared.unit = figure.unit;
  compared.smallest_that_matters = figure.smallest_that_matters;
  if (!std::isfinite(figure.value))
    return unusable(fmt::format("The figure '{}' of stage '{}' is {}, which cannot be compared.",
                                metric.measure, compared.stage, figure.value));
  return {figure.value, {}};
}

}  // namespace stope
