#pragma once

/// The code of every diagnostic that only experiment files have. docs/comparing.md explains each;
/// what experiments have in common with pipelines has the codes of framework/pipeline/codes.hpp.
namespace stope::code {

inline constexpr const char* kTooFewArms = "X001";
inline constexpr const char* kUnknownBaseline = "X002";
inline constexpr const char* kSameName = "X003";
inline constexpr const char* kTwoSeeds = "X004";
inline constexpr const char* kTooManyRuns = "X005";
inline constexpr const char* kNotANumber = "X006";
inline constexpr const char* kUnknownMetricStage = "X007";
inline constexpr const char* kNotMeasures = "X008";
inline constexpr const char* kNothingToRun = "X009";
inline constexpr const char* kUnknownFigure = "X010";
inline constexpr const char* kWrongUnitOfMatters = "X011";

}  // namespace stope::code
