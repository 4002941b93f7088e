#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace stope::report {

/// What is in `folder` besides `owned`, sorted: files, and folders that hold nothing owned, whose
/// names end in a slash. `owned` are files and streams' folders, relative to `folder`; of a
/// stream's folder the numbered files are owned as well. What cannot be read is left out.
std::vector<std::string> other_files(const std::filesystem::path& folder,
                                     const std::set<std::string>& owned);

}  // namespace stope::report
