#pragma once

#include "framework/plugins/elf_notes.hpp"
#include "framework/plugins/open_file.hpp"

namespace stope {

/// Reads a library's notes. Believes nothing the file says before checking it against the file's
/// size. Throws PluginRefused if the file is no shared library, is truncated or was built for
/// another machine.
ElfNotes read_elf(const OpenFile& file);

}  // namespace stope
