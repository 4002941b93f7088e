#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace stope::report {

/// Checks the name of an output, such as `roads.geojson` or `maps/prior.yaml`: relative, with
/// forward slashes, no part that is empty, `.` or `..` or begins with a dot, no control characters.
/// Throws Error with a sentence that quotes the name.
void check_output_name(std::string_view name);

/// The name without the `.extension` it ends in (or without its last one, if it ends in another).
std::string output_stem(std::string_view name, std::string_view extension);

/// The number of a stream's item as six digits or more: `000042`.
std::string item_stem(std::uint64_t index);

/// Whether a file is called like a stream's item: six digits or more, a dot, an extension.
bool is_item_name(std::string_view name);

/// Checks an extension that an export gave: it must not hold anything that moves the file
/// elsewhere. Throws Error.
void check_extension(std::string_view extension);

}  // namespace stope::report
