// A note from the future.
#include <stope/plugin.hpp>

namespace {
constexpr stope::AbiNote make_note() {
  stope::AbiNote note = stope::make_abi_note("wrong_epoch", "1.0.0");
  note.epoch = stope::kAbiEpoch + 1;
  return note;
}
}  // namespace

extern "C" __attribute__((section(".note.stope"), used, aligned(4)))
const stope::AbiNote stope_abi_note = make_note();

extern "C" STOPE_API const stope::PluginTable* stope_plugin() { return nullptr; }
