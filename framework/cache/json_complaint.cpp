#include "framework/cache/json_complaint.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

namespace stope {
namespace {

using Json = nlohmann::json;

/// Its numbers are documented; what the texts hold besides is taken only where it is there.
constexpr int kKeyNotFound = 403, kWrongType = 302;

/// What stands between two marks, or nothing.
std::string between(const std::string& text, const std::string& before, const std::string& after) {
  const std::size_t found = text.find(before);
  if (found == std::string::npos) return {};
  const std::size_t begin = found + before.size(), end = text.find(after, begin);
  return end == std::string::npos ? std::string() : text.substr(begin, end - begin);
}

}  // namespace

std::string json_complaint(const std::exception& error) {
  const std::string text = error.what();
  if (const auto* wrong = dynamic_cast<const Json::parse_error*>(&error))
    return fmt::format("it is not whole JSON: it goes wrong at byte {}", wrong->byte);
  const auto* wrong = dynamic_cast<const Json::exception*>(&error);
  const int id = wrong ? wrong->id : 0;
  if (const std::string key = between(text, "key '", "' not found");
      id == kKeyNotFound && !key.empty())
    return fmt::format("it lacks the entry \"{}\"", key);
  if (const std::string type = between(text, "type must be ", ", but is");
      id == kWrongType && !type.empty())
    return fmt::format("one of its entries must be of the type {} and is {}", type,
                       text.substr(text.find(", but is ") + 9));
  return "one of its entries is of a kind that cannot stand there";
}

}  // namespace stope
