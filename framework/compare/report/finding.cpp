#include "framework/compare/report/finding.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "framework/compare/remarks.hpp"
#include "framework/report/quantity_text.hpp"

namespace stope::report {
namespace {

bool shown(Verdict verdict) { return verdict == Verdict::kBetter || verdict == Verdict::kWorse; }

std::string listed(const std::vector<std::string>& items) {
  std::string text;
  for (std::size_t i = 0; i < items.size(); ++i)
    text += (i == 0 ? "" : (i + 1 == items.size() ? " and " : ", ")) + items[i];
  return text;
}

// `10 recordings`, or `8 to 10 of 12 recordings` where some measures lack some.
std::string recordings_text(const std::vector<ComparedMeasure>& measures, std::size_t all) {
  std::size_t least = measures.front().differences.size(), most = least;
  for (const ComparedMeasure& measure : measures) {
    least = std::min(least, measure.differences.size());
    most = std::max(most, measure.differences.size());
  }
  const std::string of = least < all ? fmt::format(" of {}", all) : "";
  if (least != most) return fmt::format("{} to {}{} recordings", least, most, of);
  if (!of.empty()) return fmt::format("{}{} recordings", least, of);
  return count_text(least, "recording", "recordings");
}

// `0.34 [0.28, 0.41] m`, both ways as a distance: which way the word before it says.
std::string by_how_much(const ComparedMeasure& measure, const std::string& unit) {
  ComparedMeasure turned = measure;
  if (measure.verdict == Verdict::kWorse) {
    turned.mean_difference = -measure.mean_difference;
    turned.interval = {-measure.interval.high, -measure.interval.low};
  }
  return difference_text(turned) + (unit.empty() ? "" : " " + unit);
}

// Measures of which the same is said.
struct Group {
  std::string said;  ///< text_of
  Verdict verdict;
  std::vector<const ComparedMeasure*> measures;
  std::vector<std::string> names;  ///< with by how much
};

std::vector<Group> groups_of(const Comparison& comparison, const ArmVerdicts& verdicts) {
  std::vector<Group> groups;
  for (std::size_t i = 0; i < verdicts.measures.size(); ++i) {
    const ComparedMeasure& measure = verdicts.measures[i];
    const std::string said = text_of(measure);
    auto group = std::find_if(groups.begin(), groups.end(),
                              [&](const Group& one) { return one.said == said; });
    if (group == groups.end())
      group = groups.insert(groups.end(), Group{said, measure.verdict, {}, {}});
    group->measures.push_back(&measure);
    const std::string& unit = comparison.metrics[i].unit;
    std::string name = measure.measure;
    if (shown(measure.verdict)) name += " by " + by_how_much(measure, unit);
    if (measure.all_equal() && measure.differences.front() == 0)
      name += " (equal to the last bit)";
    else if (measure.verdict == Verdict::kSame)
      name += fmt::format(" (within {}{}{})", number_text(measure.smallest_that_matters),
                          unit.empty() ? "" : " ", unit);
    group->names.push_back(std::move(name));
  }
  // What was shown and matters first, then by how much it says.
  const auto rank = [](const Group& group) {
    if (!shown(group.verdict)) return group.verdict == Verdict::kSame ? 3 : 4;
    const Weight weight = group.measures.front()->weight;
    return weight == Weight::kMatters ? 0 : (weight == Weight::kUnclear ? 1 : 2);
  };
  std::stable_sort(groups.begin(), groups.end(),
                   [&](const Group& a, const Group& b) { return rank(a) < rank(b); });
  return groups;
}

/// For a difference to be shown beside all that are tested, whatever is there by now.
std::size_t recordings_needed_by(const Comparison& comparison) {
  const auto arms = static_cast<std::size_t>(
      std::count_if(comparison.arms.begin(), comparison.arms.end(),
                    [](const ComparedArm& arm) { return arm.same_as.empty(); }));
  return recordings_needed(std::max<std::size_t>(1, (arms - 1) * comparison.metrics.size()));
}

std::string opening(const Group& group, const std::string& arm, const std::string& baseline,
                    const std::string& recordings, std::size_t needed) {
  const std::string names = listed(group.names);
  switch (group.verdict) {
    case Verdict::kBetter:
    case Verdict::kWorse: {
      // `better, and it matters`: the word goes before the figures, what it weighs after them.
      const std::size_t comma = std::min(group.said.find(','), group.said.size());
      return fmt::format("{} is {} than {} in {} on {}{}", arm, group.said.substr(0, comma),
                         baseline, names, recordings, group.said.substr(comma));
    }
    case Verdict::kSame:
      return fmt::format("{} and {} are the same in {} on {}", arm, baseline, names, recordings);
    case Verdict::kTooFew:
      return fmt::format("{} recordings are needed to say anything of {} and {} in {}: there {} {}",
                         needed, arm, baseline, names, recordings.starts_with("1 ") ? "is" : "are",
                         recordings);
    case Verdict::kNoFigure:
      return fmt::format("There is no usable figure of {} beside {} in {} on any of {}", arm,
                         baseline, names, recordings);
    default:
      return fmt::format("No difference shown between {} and {} in {} on {}", arm, baseline, names,
                         recordings);
  }
}

}  // namespace

std::string finding_text(const Comparison& comparison, const ArmVerdicts& verdicts) {
  const std::string& arm = comparison.arms[verdicts.arm].name;
  const std::string& baseline = comparison.arms[comparison.baseline].name;
  if (verdicts.measures.empty())
    return fmt::format("{}: there are no metrics to judge it by.", arm);
  const std::size_t all = distinct_recordings(comparison).size();
  if (verdicts.measures.front().verdict == Verdict::kIdentical)
    return fmt::format(
        "{} and {} left the same bytes wherever both were run: there is nothing to compare.", arm,
        baseline);
  const std::vector<Group> groups = groups_of(comparison, verdicts);
  std::string text = opening(groups.front(), arm, baseline,
                             groups.front().verdict == Verdict::kNoFigure
                                 ? count_text(all, "recording", "recordings")
                                 : recordings_text(verdicts.measures, all),
                             recordings_needed_by(comparison));
  const std::string losses = losses_text(comparison, verdicts.arm);
  if (!losses.empty()) text += "; " + losses;
  for (std::size_t i = 1; i < groups.size(); ++i)
    text += fmt::format("; {} in {}", groups[i].said, listed(groups[i].names));
  text += ".";
  for (const std::string& remark : remarks_of(comparison, verdicts)) text += " " + remark;
  return text;
}

std::string to_width(double value, double width) {
  if (!std::isfinite(value)) return "–";
  if (!(width > 0)) return number_text(value);
  const int places = std::clamp(1 - static_cast<int>(std::floor(std::log10(width))), 0, 9);
  const double step = std::pow(10.0, places);
  const double rounded = std::round(value * step) / step;
  // Never -0.00.
  return fmt::format("{:.{}f}", rounded == 0 ? 0.0 : rounded, places);
}

std::string difference_text(const ComparedMeasure& measure) {
  if (!measure.has_interval()) return number_text(measure.mean_difference) + " [–]";
  const double width = measure.interval.high - measure.interval.low;
  return fmt::format("{} [{}, {}]", to_width(measure.mean_difference, width),
                     to_width(measure.interval.low, width), to_width(measure.interval.high, width));
}

std::string chance_text(double chance) {
  if (chance < 0.001) return "< 0.001";
  return fmt::format("{:.{}f}", chance, chance < 0.1 ? 3 : 2);
}

}  // namespace stope::report
