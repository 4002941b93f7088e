#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "stope/abi_note.hpp"

namespace stope {

/// What the notes of a library tell.
struct ElfNotes {
  /// The Stope note. Of a note of another length only the head, `epoch`, is filled.
  std::optional<AbiNote> stope;
  bool complete = false;  ///< the Stope note has the length this framework knows
  std::string build_id;   ///< hexadecimal, or empty
};

/// Takes from a run of ELF notes those that matter and that `notes` has not got yet. Stops at the
/// first that cannot be right.
void take_notes(const std::vector<char>& bytes, std::uint64_t alignment, ElfNotes& notes);

}  // namespace stope
