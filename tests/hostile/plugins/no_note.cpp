// Exports a table but carries no note.
#include <stope/plugin.hpp>

extern "C" STOPE_API const stope::PluginTable* stope_plugin() { return nullptr; }
