#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "stope/parameter.hpp"

namespace stope {

/// An input or output of a stage, as declared.
struct PortInfo {
  std::string name;
  std::string type;          ///< the payload's kType
  std::uint64_t layout = 0;  ///< the payload's layout_hash()
  bool stream = true;        ///< any number of items; else exactly one
  bool required = true;      ///< of an input: must be wired
  std::string doc;           ///< one sentence
};

/// Everything a stage declares about itself, known without running it.
struct StageInfo {
  std::string id;       ///< `family/name`
  std::string summary;  ///< one sentence
  std::string source;   ///< where the method comes from: paper and section
  std::string notes;    ///< what a user must know before choosing it
  std::vector<PortInfo> inputs, outputs;
  std::vector<ParameterInfo> parameters;
  /// A pure function of one item from each input. Its outputs are streams if a wired input is one,
  /// whatever PortInfo::stream says; its inputs and outputs take streams and values.
  bool map = false;
  bool in_order = false;      ///< of a map: is given one item at a time, in order
  bool deterministic = true;  ///< same inputs, same bytes
  bool live = false;          ///< may drop items when the run cannot keep pace
  /// Has also_reads(): reads more files than its parameters of kind path name.
  bool also_reads = false;
  std::vector<std::string>
      extensions;  ///< of an export: the file endings it writes, without the dot
};

}  // namespace stope
