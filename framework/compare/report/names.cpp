#include "framework/compare/report/downloads.hpp"

namespace stope::report {

const char* name_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::kIdentical:
      return "identical";
    case Verdict::kTooFew:
      return "too_few";
    case Verdict::kBetter:
      return "better";
    case Verdict::kWorse:
      return "worse";
    case Verdict::kSame:
      return "same";
    case Verdict::kNoDifferenceShown:
      break;
  }
  return "no_difference_shown";
}

const char* name_of(CellStatus status) {
  switch (status) {
    case CellStatus::kDone:
      return "done";
    case CellStatus::kFailed:
      return "failed";
    case CellStatus::kExcluded:
      return "excluded";
    case CellStatus::kPending:
      break;
  }
  return "pending";
}

const char* name_of(StageFate fate) {
  switch (fate) {
    case StageFate::kRan:
      return "ran";
    case StageFate::kShared:
      return "shared";
    case StageFate::kStored:
      return "stored";
    case StageFate::kNotNeeded:
      break;
  }
  return "not_needed";
}

}  // namespace stope::report
