#pragma once

#include <string>
#include <vector>

#include "framework/diagnostics/diagnostic.hpp"

namespace stope {

/// Whether an output's name stays in the output folder and can be written on any file system, with
/// an extension. Reports what is wrong with it.
bool check_output_name(const std::string& name, const Place& place, Diagnostics& diagnostics);

/// The extensions a name can be read as, longest first: `a.tar.gz` gives `tar.gz`, `gz`.
std::vector<std::string> extensions_of(const std::string& name);

/// The last part of a name without this extension: `maps/pit.tar.gz` and `tar.gz` give `pit`.
std::string stem_of(const std::string& name, const std::string& extension);

}  // namespace stope
