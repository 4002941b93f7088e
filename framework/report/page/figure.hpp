#pragma once

#include <string>
#include <vector>

#include "framework/report/sketch.hpp"

namespace stope::report {

/// A sketch as it is shown: on what it stands and under which name.
struct FigureParts {
  const Sketch* sketch = nullptr;
  const Sketch* ground = nullptr;  ///< whose raster lies below, if the sketch has none; or null
  const Sketch* roads = nullptr;   ///< whose strokes lie faintly below; or null
  std::string name;                ///< `roads.roads`
  std::string remark;              ///< `first of 110 items`; or empty
  bool wide = false;               ///< across the page
};

/// The sketch as a <figure> with a scale bar, a north arrow, a caption and a legend. Empty if there
/// is nothing to be seen.
std::string figure_html(const FigureParts& parts);

/// A round length (1, 2 or 5 times a power of ten, metres) of at most a quarter of `width` metres.
double scale_bar_length(double width);

}  // namespace stope::report
