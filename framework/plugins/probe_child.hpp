#pragma once

#include <filesystem>

namespace stope {

/// The child's part of a probe: opens the plugin, describes its stages, and writes ProbeMessages to
/// `descriptor`. Leaves the process without running anything that belongs to the parent.
[[noreturn]] void run_probe_child(const std::filesystem::path& file, int descriptor) noexcept;

}  // namespace stope
