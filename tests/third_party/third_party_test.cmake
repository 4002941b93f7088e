# See CMakeLists.txt beside it. Run with cmake -P.
set(acme "${CMAKE_CURRENT_LIST_DIR}/acme")
set(prefix "${WORK}/prefix")
set(build "${WORK}/build")
set(elsewhere "${WORK}/elsewhere")

function(run)
  execute_process(COMMAND ${ARGN} WORKING_DIRECTORY "${elsewhere}" COMMAND_ECHO STDOUT COMMAND_ERROR_IS_FATAL ANY)
endfunction()

file(REMOVE_RECURSE "${WORK}")
file(MAKE_DIRECTORY "${elsewhere}")
set(ENV{XDG_CACHE_HOME} "${WORK}/cache")
set(ENV{XDG_DATA_HOME} "${WORK}/data")
unset(ENV{STOPE_PLUGIN_PATH})

run("${CMAKE_COMMAND}" --install "${STOPE_BUILD}" --prefix "${prefix}")

# Nothing installed may lead back to where Stope was built.
execute_process(
  COMMAND grep -rlF -e "${STOPE_SOURCE}/" -e "${STOPE_BUILD}/" "${prefix}/lib/cmake" "${prefix}/include"
  OUTPUT_VARIABLE leading_back RESULT_VARIABLE grep_result)
if(NOT grep_result EQUAL 1) # 1: no line found
  message(FATAL_ERROR "These files lead back to ${STOPE_SOURCE} or ${STOPE_BUILD}:\n${leading_back}")
endif()

run("${CMAKE_COMMAND}" -S "${acme}" -B "${build}" -G "${GENERATOR}" "-DCMAKE_PREFIX_PATH=${prefix}"
    "-DCMAKE_CXX_COMPILER=${COMPILER}" "-DCMAKE_CXX_COMPILER_LAUNCHER=${LAUNCHER}" "-DCMAKE_BUILD_TYPE=${BUILD_TYPE}")
file(STRINGS "${build}/CMakeCache.txt" found REGEX "^Stope_DIR:PATH=${prefix}/")
if(NOT found)
  message(FATAL_ERROR "find_package(Stope) found another Stope than the one in ${prefix}")
endif()
run("${CMAKE_COMMAND}" --build "${build}")
run("${CMAKE_CTEST_COMMAND}" --test-dir "${build}" --output-on-failure)

run("${prefix}/bin/stope" inspect acme/census --plugin-path "${build}")
run("${prefix}/bin/stope" run "${acme}/acme.yaml" --out "${WORK}/out" --plugin-path "${build}")
file(READ "${WORK}/out/outputs/census.acme" census)
if(NOT census STREQUAL "sectors\t4\ncells\t100\n")
  message(FATAL_ERROR "The pipeline counted wrongly:\n${census}")
endif()
