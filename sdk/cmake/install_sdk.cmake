# What `cmake --install` puts into a prefix for authors of plugins: the library, its headers, the headers for tests, and
# the package that find_package(Stope) finds. `--component sdk` installs them alone.
include(CMakePackageConfigHelpers)

set(package_folder "${CMAKE_INSTALL_LIBDIR}/cmake/Stope")
install(TARGETS stope_sdk stope_testing EXPORT StopeTargets LIBRARY DESTINATION "${CMAKE_INSTALL_LIBDIR}"
                                                                  COMPONENT sdk)
install(DIRECTORY include/stope testing/include/stope DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}" COMPONENT sdk)
install(EXPORT StopeTargets NAMESPACE Stope:: DESTINATION "${package_folder}" COMPONENT sdk)

configure_package_config_file(
  cmake/StopeConfig.cmake.in "${CMAKE_CURRENT_BINARY_DIR}/StopeConfig.cmake" INSTALL_DESTINATION "${package_folder}")
write_basic_package_version_file("${CMAKE_CURRENT_BINARY_DIR}/StopeConfigVersion.cmake" COMPATIBILITY SameMinorVersion)
install(FILES "${CMAKE_CURRENT_BINARY_DIR}/StopeConfig.cmake" "${CMAKE_CURRENT_BINARY_DIR}/StopeConfigVersion.cmake"
              cmake/stope_add_plugin.cmake DESTINATION "${package_folder}" COMPONENT sdk)
