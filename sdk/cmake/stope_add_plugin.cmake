# stope_add_plugin(<id> [VERSION <x.y.z>] STAGES <stage>... [SOURCES <file>...] [LIBRARIES <target>...])
#
# Builds the plugin <id> as one shared library from <stage>.cpp for each stage (snake_case; the file exports the class
# of the same name in PascalCase with STOPE_STAGE) and from SOURCES, files the stages share. It exports one symbol.
#
# Makes two targets:
#   stope_plugin_<id>  the library. Include directories, definitions and options given to it (PRIVATE) reach the sources.
#   stope_stages_<id>  the same objects, to link into unit tests of the stages.
#
# Where the library is built: STOPE_PLUGIN_OUTPUT_DIRECTORY, or the current build folder. `cmake --install` puts it into
# lib/stope/plugins, where the Stope of that prefix finds it, or into STOPE_PLUGIN_INSTALL_DIRECTORY; nowhere if that is
# set and empty.
function(stope_add_plugin id)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "VERSION" "STAGES;SOURCES;LIBRARIES")
  if(NOT arg_STAGES)
    message(FATAL_ERROR "stope_add_plugin(${id}): name at least one stage after STAGES.")
  endif()
  if(arg_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "stope_add_plugin(${id}): put '${arg_UNPARSED_ARGUMENTS}' after STAGES, SOURCES or LIBRARIES.")
  endif()
  string(LENGTH "${id}" id_length)
  if(NOT id MATCHES "^[a-z][a-z0-9_]*$" OR id_length GREATER 47)
    message(FATAL_ERROR "stope_add_plugin(${id}): an id is snake_case and at most 47 characters long.")
  endif()
  if(NOT arg_VERSION)
    set(arg_VERSION "${PROJECT_VERSION}")
  endif()

  set(table "${CMAKE_CURRENT_BINARY_DIR}/${id}_plugin.cpp")
  set(exports "${CMAKE_CURRENT_BINARY_DIR}/${id}_exports.map")
  _stope_write_plugin_table("${id}" "${arg_VERSION}" "${arg_STAGES}" "${table}")
  file(CONFIGURE OUTPUT "${exports}" CONTENT "{ global: stope_plugin; local: *; };\n")

  set(plugin "stope_plugin_${id}")
  set(stages "stope_stages_${id}")
  list(TRANSFORM arg_STAGES APPEND ".cpp" OUTPUT_VARIABLE stage_files)

  add_library(${stages} OBJECT ${stage_files} ${arg_SOURCES})
  target_link_libraries(${stages} PUBLIC Stope::sdk ${arg_LIBRARIES})
  target_include_directories(${stages} PRIVATE "$<TARGET_PROPERTY:${plugin},INCLUDE_DIRECTORIES>")
  target_compile_definitions(${stages} PRIVATE "$<TARGET_PROPERTY:${plugin},COMPILE_DEFINITIONS>")
  target_compile_options(${stages} PRIVATE "$<TARGET_PROPERTY:${plugin},COMPILE_OPTIONS>")

  add_library(${plugin} MODULE "${table}" "$<TARGET_OBJECTS:${stages}>")
  target_link_libraries(${plugin} PRIVATE Stope::sdk ${arg_LIBRARIES})
  if(TARGET stope_build_flags) # the project's own plugins
    target_link_libraries(${plugin} PRIVATE stope_build_flags)
  endif()

  foreach(target IN ITEMS ${stages} ${plugin})
    set_target_properties(
      ${target} PROPERTIES POSITION_INDEPENDENT_CODE ON CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
    # No contraction: the same bytes on every machine. No unique symbols: they would be shared between plugins.
    target_compile_options(${target} PRIVATE -ffp-contract=off $<$<CXX_COMPILER_ID:GNU>:-fno-gnu-unique>)
  endforeach()
  # Installed, libstope.so is two folders up; other libraries are where they were found.
  set_target_properties(
    ${plugin} PROPERTIES PREFIX "" OUTPUT_NAME "${id}" LINK_DEPENDS "${exports}" INSTALL_RPATH "$ORIGIN/../.."
                         INSTALL_RPATH_USE_LINK_PATH ON)
  if(STOPE_PLUGIN_OUTPUT_DIRECTORY)
    set_target_properties(${plugin} PROPERTIES LIBRARY_OUTPUT_DIRECTORY "${STOPE_PLUGIN_OUTPUT_DIRECTORY}")
  endif()
  target_link_options(
    ${plugin} PRIVATE "LINKER:--version-script=${exports}" LINKER:-z,nodelete LINKER:--build-id=sha1)
  if(STOPE_SANITIZE)
    # Both sides alike, and the tests that link the stages with them. clang's sanitizers take their own symbols from the
    # executable, so that the linker cannot ask for all symbols.
    target_compile_options(${stages} PUBLIC "-fsanitize=${STOPE_SANITIZE}")
    target_link_options(${stages} PUBLIC "-fsanitize=${STOPE_SANITIZE}")
    target_compile_options(${plugin} PRIVATE "-fsanitize=${STOPE_SANITIZE}")
    target_link_options(${plugin} PRIVATE "-fsanitize=${STOPE_SANITIZE}")
  else()
    target_link_options(${plugin} PRIVATE LINKER:-z,defs)
  endif()

  if(NOT DEFINED STOPE_PLUGIN_INSTALL_DIRECTORY)
    install(TARGETS ${plugin} LIBRARY DESTINATION lib/stope/plugins)
  elseif(STOPE_PLUGIN_INSTALL_DIRECTORY)
    install(TARGETS ${plugin} LIBRARY DESTINATION "${STOPE_PLUGIN_INSTALL_DIRECTORY}")
  endif()
endfunction()

# Writes the source file with the plugin's table: one function call for each stage.
function(_stope_write_plugin_table id version stages file)
  set(declarations "")
  set(calls "")
  foreach(stage IN LISTS stages)
    if(NOT stage MATCHES "^[a-z][a-z0-9]*(_[a-z0-9]+)*$")
      message(FATAL_ERROR "stope_add_plugin(${id}): the stage '${stage}' must be snake_case, as its file without .cpp.")
    endif()
    string(REPLACE "_" ";" words "${stage}")
    set(class "")
    foreach(word IN LISTS words)
      string(SUBSTRING "${word}" 0 1 first)
      string(SUBSTRING "${word}" 1 -1 rest)
      string(TOUPPER "${first}" first)
      string(APPEND class "${first}${rest}")
    endforeach()
    string(APPEND declarations "extern \"C\" const stope::StageEntry* stope_stage_${class}();\n")
    list(APPEND calls "stope_stage_${class}()")
  endforeach()
  list(JOIN calls ", " calls)
  file(CONFIGURE OUTPUT "${file}" CONTENT
"// Generated by stope_add_plugin().
#include <stope/plugin.hpp>

@declarations@
STOPE_PLUGIN(\"@id@\", \"@version@\", @calls@)
" @ONLY)
endfunction()
