#pragma once

#include <string>

#include "framework/compare/statistics/verdict.hpp"

namespace stope::report {

/// A verdict as the page marks it, told apart by shape as well as by colour.
struct VerdictMark {
  const char* style;  ///< class of the style sheet
  const char* sign;
};

inline VerdictMark mark_of(const ComparedMeasure& measure) {
  switch (measure.verdict) {
    case Verdict::kBetter:
      return {measure.weight == Weight::kNegligible ? "better slight" : "better", "▲"};
    case Verdict::kWorse:
      return {measure.weight == Weight::kNegligible ? "worse slight" : "worse", "▼"};
    case Verdict::kSame:
      return {"same", "="};
    case Verdict::kIdentical:
      return {"same", "≡"};
    case Verdict::kTooFew:
      return {"unknown", "…"};
    case Verdict::kNoFigure:
      return {"unknown", "∅"};
    case Verdict::kNoDifferenceShown:
      break;
  }
  return {"unknown", "○"};
}

}  // namespace stope::report
