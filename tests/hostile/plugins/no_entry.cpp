// A right note, but not the function that gives the table.
#include <stope/plugin.hpp>

extern "C" __attribute__((section(".note.stope"), used, aligned(4)))
const stope::AbiNote stope_abi_note = stope::make_abi_note("no_entry", "1.0.0");
