#pragma once

#include <string>
#include <string_view>
#include <vector>

/// Small parts of sentences for an operator.
namespace stope {

/// `'a', 'b' and 'c'`, in the order given; after `most` names, "and 3 more".
std::string quoted_list(const std::vector<std::string>& names, std::string_view last = "and",
                        std::size_t most = 8);

/// "Did you mean 'x'?", or `otherwise` if no candidate is near.
std::string did_you_mean(std::string_view name, const std::vector<std::string>& candidates,
                         std::string otherwise = "");

/// Two hints, with a space between if both are there.
std::string joined(std::string first, std::string_view second);

/// A text as it can be shown in one line: cut when long, control characters as `\xNN`.
std::string shown(std::string_view text);

}  // namespace stope
