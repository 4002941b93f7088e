#pragma once

#include <optional>
#include <string>

#include "stope/stage_info.hpp"

namespace stope {

/// Which output a wire means.
struct OutputChoice {
  std::optional<std::size_t> port;  ///< if it is clear
  bool ambiguous = false;           ///< several could be meant; else there is none of that name
};

/// A named port is that port. Otherwise the stage's only output, else the one called like the input
/// and of its type, else the only one of its type, else the one called like the input.
OutputChoice choose_output(const StageInfo& producer, const std::string& port,
                           const PortInfo* input);

/// Whether payloads of the output can go into the input: same type, same layout.
bool same_payload(const PortInfo& output, const PortInfo& input);

/// The input a wire goes to: the one it names; in the short form the only required one, else the
/// only one.
std::optional<std::size_t> choose_input(const StageInfo& reader, const std::string& name);

}  // namespace stope
