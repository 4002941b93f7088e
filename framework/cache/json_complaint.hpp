#pragma once

#include <exception>
#include <string>

namespace stope {

/// What the JSON library complains of, as the second half of a sentence whose first names the file:
/// `it lacks the entry "stages"`, `it is not whole JSON: it goes wrong at byte 17`.
std::string json_complaint(const std::exception& error);

}  // namespace stope
