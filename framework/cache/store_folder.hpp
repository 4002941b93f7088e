#pragma once

#include <filesystem>
#include <string>

namespace stope {

/// Whether a folder is a store: it bears the mark that Stope leaves in those it makes, or holds
/// what stores of before 0.1 held, which had none, and nothing else.
bool is_store(const std::filesystem::path& folder);

/// Why a path cannot be a store, as a sentence: something else is there. Empty if a store is, or
/// one can be made.
std::string why_no_store(const std::filesystem::path& folder);

/// Makes a folder a store unless it is one. Several processes may do so at once. Throws Error with
/// a sentence if it cannot, or if something else is there.
void make_store(const std::filesystem::path& folder);

}  // namespace stope
