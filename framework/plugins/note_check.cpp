#include "framework/plugins/note_check.hpp"

#include <fmt/format.h>

#include <string>

#include "framework/plugins/plugin_file.hpp"

namespace stope {

namespace {

std::string sanitizers_name(std::uint32_t bits) {
  if (bits == 0) return "without sanitizers";
  if (bits == 1) return "with AddressSanitizer";
  if (bits == 2) return "with ThreadSanitizer";
  return fmt::format("with sanitizers {:#x}", bits);
}

std::string missing_features(std::uint32_t needed) {
  std::string missing;
  const auto need = [&](std::uint32_t feature, bool here, const char* name) {
    if ((needed & feature) == 0) return;
    needed &= ~feature;
    if (!here) missing += (missing.empty() ? "" : ", ") + std::string(name);
  };
#if defined(__x86_64__)
  need(kCpuAvx, __builtin_cpu_supports("avx"), "AVX");
  need(kCpuAvx2, __builtin_cpu_supports("avx2"), "AVX2");
  need(kCpuFma, __builtin_cpu_supports("fma"), "FMA");
  need(kCpuAvx512f, __builtin_cpu_supports("avx512f"), "AVX-512F");
#endif
  need(needed, false, "features this Stope does not know");
  return missing;
}

/// What differs in how the two sides were compiled: one sentence each.
std::string build_differences(const AbiNote& plugin, const AbiNote& host) {
  std::string text;
  const auto say = [&text](const std::string& sentence) {
    text += (text.empty() ? "" : " ") + sentence;
  };
  if (plugin.compiler_family != host.compiler_family) {
    say("It was built with a compiler whose classes may be laid out differently: rebuild it with "
        "g++ 12 or newer or clang++ 14 or newer.");
  }
  if (plugin.libstdcxx_abi != host.libstdcxx_abi) {
    say(plugin.libstdcxx_abi == 0
            ? "It was built with the old libstdc++ strings: rebuild it without "
              "_GLIBCXX_USE_CXX11_ABI=0."
            : "It was built with another C++ standard library: rebuild it with libstdc++, without "
              "-stdlib=libc++.");
  }
  if (plugin.eigen_alignment != host.eigen_alignment) {
    say(fmt::format(
        "It was built with Eigen types aligned to {} bytes, this Stope to {}: rebuild it "
        "without -march=native, -mavx or EIGEN_MAX_ALIGN_BYTES, which change that.",
        plugin.eigen_alignment, host.eigen_alignment));
  }
  if (plugin.sanitizers != host.sanitizers) {
    say(fmt::format("It was built {}, this Stope {}: rebuild one of them.",
                    sanitizers_name(plugin.sanitizers), sanitizers_name(host.sanitizers)));
  }
  if (plugin.fast_math != 0) {
    say("It was built with -ffast-math, which breaks infinities and NaN and changes results from "
        "machine to machine: rebuild it without -ffast-math and -Ofast.");
  }
  return text;
}

}  // namespace

void check_note(const ElfNotes& notes) {
  if (!notes.stope) {
    throw PluginRefused(PluginStatus::kNoNote,
                        "It is a library but carries no Stope note: build it with "
                        "stope_add_plugin(), or move it out of the plugin folder.");
  }
  const AbiNote host = make_abi_note("", "");
  if (notes.stope->epoch != host.epoch) {
    throw PluginRefused(
        PluginStatus::kOtherEpoch,
        fmt::format(
            "It was built for ABI epoch {}, this Stope has epoch {}: rebuild it against the "
            "SDK of this Stope{}.",
            notes.stope->epoch, host.epoch,
            notes.stope->epoch > host.epoch ? ", or use the newer Stope it was built for" : ""));
  }
  if (!notes.complete) {
    throw PluginRefused(PluginStatus::kNoNote,
                        "Its Stope note is damaged: it has another length than notes of its epoch. "
                        "Rebuild it with stope_add_plugin().");
  }
  if (const std::string text = build_differences(*notes.stope, host); !text.empty()) {
    throw PluginRefused(PluginStatus::kBuiltOtherwise, text);
  }
  if (const std::string missing = missing_features(notes.stope->cpu_features); !missing.empty()) {
    throw PluginRefused(PluginStatus::kOtherMachine,
                        fmt::format("It needs instructions this processor lacks ({}): rebuild it "
                                    "without -march= and -m options.",
                                    missing));
  }
}

}  // namespace stope
