#pragma once

#include <array>
#include <cstddef>

#include "framework/compare/comparison.hpp"

/// The words that stand in files for the states of a comparison, in the order of the enumerators.
namespace stope::words {

inline constexpr std::array kDirections{"higher", "lower"};
inline constexpr std::array kFates{"ran", "shared", "stored", "not_needed"};
inline constexpr std::array kKinds{"picture", "geojson", "measures", "other"};
inline constexpr std::array kStatuses{"pending", "done", "failed", "excluded"};
inline constexpr std::array kVerdicts{"identical",           "too_few",  "better", "worse", "same",
                                      "no_difference_shown", "no_figure"};

template <class E, class Words>
constexpr const char* word_for(E value, const Words& words) {
  return words[static_cast<std::size_t>(value)];
}

}  // namespace stope::words
