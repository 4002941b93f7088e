#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace stope {

/// Changes when a plugin built before can no longer be used. Not the release number.
inline constexpr std::uint32_t kAbiEpoch = 3;

/// What a plugin was built with, kept in the ELF note `.note.stope`, which the framework reads
/// before it opens the library. Fixed-size and plain so that any version of the framework can read
/// any version of the note's head.
struct AbiNote {
  std::uint32_t name_size = 8;  ///< ELF note header: size of `name`
  std::uint32_t desc_size = 0;  ///< ELF note header: size of what follows `name`
  std::uint32_t type = 1;       ///< ELF note header: 1 is this note
  char name[8] = "Stope";
  std::uint32_t epoch = kAbiEpoch;
  std::uint32_t compiler_family = 0;  ///< 1: g++ >= 12 or clang >= 14 (Itanium ABI)
  std::uint32_t libstdcxx_abi = 0;    ///< _GLIBCXX_USE_CXX11_ABI, or 2 for another standard library
  std::uint32_t eigen_alignment = 0;  ///< EIGEN_MAX_ALIGN_BYTES
  std::uint32_t sanitizers = 0;       ///< bit 0 address, bit 1 thread
  std::uint32_t fast_math = 0;        ///< __FAST_MATH__ was defined
  std::uint32_t cpu_features = 0;     ///< instruction sets the code needs: see kCpu…
  char plugin_id[48] = {};
  char plugin_version[24] = {};
};
static_assert(alignof(AbiNote) == 4, "the note's parts stand at multiples of 4 in the file");

inline constexpr std::uint32_t kCpuAvx = 1, kCpuAvx2 = 2, kCpuFma = 4, kCpuAvx512f = 8;

/// The note of the code that includes this header, as its compiler sees it.
constexpr AbiNote make_abi_note(std::string_view plugin_id, std::string_view plugin_version) {
  AbiNote note;
  note.desc_size = sizeof(AbiNote) - 3 * sizeof(std::uint32_t) - sizeof(note.name);
#if (defined(__clang__) && __clang_major__ >= 14) || \
    (!defined(__clang__) && defined(__GNUC__) && __GNUC__ >= 12)
  note.compiler_family = 1;
#endif
#ifdef _GLIBCXX_USE_CXX11_ABI
  note.libstdcxx_abi = _GLIBCXX_USE_CXX11_ABI;
#else
  note.libstdcxx_abi = 2;
#endif
  note.eigen_alignment = EIGEN_MAX_ALIGN_BYTES;
#if defined(__SANITIZE_ADDRESS__)
  note.sanitizers |= 1;
#endif
#if defined(__SANITIZE_THREAD__)
  note.sanitizers |= 2;
#endif
#if defined(__has_feature)
#if __has_feature(address_sanitizer)
  note.sanitizers |= 1;
#endif
#if __has_feature(thread_sanitizer)
  note.sanitizers |= 2;
#endif
#endif
#ifdef __FAST_MATH__
  note.fast_math = 1;
#endif
#ifdef __AVX__
  note.cpu_features |= kCpuAvx;
#endif
#ifdef __AVX2__
  note.cpu_features |= kCpuAvx2;
#endif
#ifdef __FMA__
  note.cpu_features |= kCpuFma;
#endif
#ifdef __AVX512F__
  note.cpu_features |= kCpuAvx512f;
#endif
  for (std::size_t i = 0; i < plugin_id.size() && i + 1 < sizeof(note.plugin_id); ++i)
    note.plugin_id[i] = plugin_id[i];
  for (std::size_t i = 0; i < plugin_version.size() && i + 1 < sizeof(note.plugin_version); ++i)
    note.plugin_version[i] = plugin_version[i];
  return note;
}

}  // namespace stope
