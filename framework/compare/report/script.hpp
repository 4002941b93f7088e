#pragma once

namespace stope::report {

/// What makes the comparison page move: it fills the viewer for the chosen recording, seed and arm,
/// and moves the slider. Without it everything else can still be read.
const char* comparison_script();

}  // namespace stope::report
