#pragma once

#include "framework/plugins/elf_notes.hpp"

namespace stope {

/// Holds a library's note against how this framework was built and against this machine. Throws
/// PluginRefused with one sentence for each thing that differs, saying what to rebuild.
void check_note(const ElfNotes& notes);

}  // namespace stope
