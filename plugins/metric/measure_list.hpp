#pragma once

#include <string>

#include "stope/payloads/measures.hpp"

namespace stope::metric {

/// Collects figures under one note, which says what they were computed with.
class MeasureList {
 public:
  explicit MeasureList(std::string note) : note_(std::move(note)) {}
  MeasureList& add(std::string name, double value, std::string unit = "") {
    measures_.names.push_back(std::move(name));
    measures_.values.push_back(value);
    measures_.units.push_back(std::move(unit));
    measures_.notes.push_back(note_);
    return *this;
  }
  Measures take() { return std::move(measures_); }

 private:
  std::string note_;
  Measures measures_;
};

/// 2ab / (a + b); 0 unless both are positive.
inline double harmonic_mean(double a, double b) { return a > 0 && b > 0 ? 2 * a * b / (a + b) : 0; }

}  // namespace stope::metric
