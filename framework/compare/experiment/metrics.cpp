#include "framework/compare/experiment/metrics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "framework/compare/experiment/codes.hpp"
#include "framework/pipeline/codes.hpp"
#include "framework/pipeline/sentence.hpp"

namespace stope {
namespace {

constexpr const char* kForm = "Write 'name: {from: stage, better: higher, matters: 0.01}'.";
const std::vector<std::string> kKeys{"from", "measure", "better", "matters"};

class MetricReader {
 public:
  MetricReader(const LocatedEntry& entry, Diagnostics& diagnostics)
      : entry_(entry), diagnostics_(diagnostics) {}

  ExperimentMetric read() {
    metric_.name = metric_.measure = entry_.key;
    metric_.measure_place = entry_.place;
    if (!entry_.value.is_map()) {
      diagnostics_.error(code::kWrongKind, entry_.value.place,
                         fmt::format("The metric '{}' must be a map, here stands {}.",
                                     shown(entry_.key), kind_name(entry_.value)),
                         fmt::format("Write '{}: {{from: stage, better: higher, matters: 0.01}}'.",
                                     shown(entry_.key)));
      return std::move(metric_);
    }
    for (const LocatedEntry& key : entry_.value.entries)
      if (std::find(kKeys.begin(), kKeys.end(), key.key) == kKeys.end())
        diagnostics_.error(
            code::kUnknownKey, key.place,
            fmt::format("A metric has no key '{}'; it has {}.", shown(key.key), quoted_list(kKeys)),
            did_you_mean(key.key, kKeys));
    if (const LocatedNode* from = text("from", "Name the stage that gives its measures.")) {
      const auto dot = from->text.find('.');
      metric_.stage = from->text.substr(0, dot);
      if (dot != std::string::npos) metric_.port = from->text.substr(dot + 1);
      metric_.stage_place = from->place;
    }
    if (entry_.value.find("measure"))
      if (const LocatedNode* measure = text("measure", "")) {
        metric_.measure = measure->text;
        metric_.measure_place = measure->place;
      }
    read_better();
    read_matters();
    return std::move(metric_);
  }

 private:
  const LocatedNode* text(const char* key, const char* hint) {
    const LocatedEntry* found = entry_.value.find(key);
    if (found && found->value.is_scalar() && !found->value.text.empty()) return &found->value;
    diagnostics_.error(found ? code::kWrongKind : code::kMissingKey,
                       found ? found->value.place : entry_.place,
                       fmt::format("The metric '{}' {} '{}'.", shown(entry_.key),
                                   found ? "must have a text as" : "has no", key),
                       hint);
    return nullptr;
  }

  void read_better() {
    const LocatedNode* better = text("better", "Write 'better: higher' or 'better: lower'.");
    if (!better) return;
    metric_.direction = better->text == "lower" ? Direction::kLower : Direction::kHigher;
    if (better->text != "lower" && better->text != "higher")
      diagnostics_.error(
          code::kWrongKind, better->place,
          fmt::format("'better' is 'higher' or 'lower', not '{}'.", shown(better->text)),
          did_you_mean(better->text, {"higher", "lower"}));
  }

  void read_matters() {
    const LocatedNode* matters = text(
        "matters", "Write the smallest difference that matters to you, such as 'matters: 0.01'.");
    if (!matters) return;
    metric_.matters_place = matters->place;
    const auto quantity = parse_quantity(matters->text);
    if (quantity && std::isfinite(quantity->number) && quantity->number >= 0)
      metric_.smallest_that_matters = *quantity;
    else
      diagnostics_.error(code::kNotANumber, matters->place,
                         fmt::format("'matters' is a number of 0 or more, such as 0.01 or 0.5 m, "
                                     "not '{}'.",
                                     shown(matters->text)));
  }

  const LocatedEntry& entry_;
  Diagnostics& diagnostics_;
  ExperimentMetric metric_;
};

}  // namespace

std::vector<ExperimentMetric> read_metrics(const LocatedNode& node, Diagnostics& diagnostics) {
  std::vector<ExperimentMetric> metrics;
  if (!node.is_map())
    diagnostics.error(code::kWrongKind, node.place,
                      fmt::format("'metrics' must be a map, here stands {}.", kind_name(node)),
                      kForm);
  else if (node.entries.empty())
    diagnostics.error(code::kWrongKind, node.place, "'metrics' names no metric.", kForm);
  for (const LocatedEntry& entry : node.entries)
    metrics.push_back(MetricReader(entry, diagnostics).read());
  return metrics;
}

}  // namespace stope
