#pragma once

#include <filesystem>
#include <string>

#include "stope/parameter.hpp"

namespace stope {

/// A path as written, made absolute and normal. `folder` is what it is relative to; empty: the
/// working directory. A leading `~/` is the home folder.
std::filesystem::path absolute_path(const std::string& text, const std::string& folder);

/// What is wrong with a path that must exist; both empty if nothing is.
struct PathProblem {
  std::string sentence;  ///< as the end of a sentence about a parameter
  std::string hint;
};

/// Holds a path against what it must name. Says how far the path exists and which name is nearest.
PathProblem look_at_path(const std::filesystem::path& path, PathKind kind);

}  // namespace stope
