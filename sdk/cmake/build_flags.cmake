# How the project's own targets are compiled, as one target each of them links.
find_program(CCACHE_PROGRAM ccache)
if(CCACHE_PROGRAM)
  set(CMAKE_CXX_COMPILER_LAUNCHER "${CCACHE_PROGRAM}")
endif()

add_library(stope_build_flags INTERFACE)
target_compile_features(stope_build_flags INTERFACE cxx_std_20)
target_compile_options(
  stope_build_flags INTERFACE -Wall -Wextra -Wpedantic -Werror -ffp-contract=off)
if(STOPE_SANITIZE)
  # g++ sees uninitialized values that are not there in code that a sanitizer has rewritten.
  target_compile_options(
    stope_build_flags INTERFACE "-fsanitize=${STOPE_SANITIZE}" -fno-omit-frame-pointer -Wno-maybe-uninitialized)
  target_link_options(stope_build_flags INTERFACE "-fsanitize=${STOPE_SANITIZE}")
endif()
