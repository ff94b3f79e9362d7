# What `cmake --install` lays down: library, headers, command, and the package that find_package(cdfr) reads.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/cdfr)
get_target_property(library_type cdfr TYPE)
if(library_type STREQUAL "SHARED_LIBRARY")
  set(CDFR_NEEDS_STATIC_DEPENDENCIES OFF)
else()
  set(CDFR_NEEDS_STATIC_DEPENDENCIES ON)
endif()

install(TARGETS cdfr EXPORT cdfr_targets)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/cdfr TYPE INCLUDE FILES_MATCHING PATTERN "*.h")
install(EXPORT cdfr_targets NAMESPACE cdfr:: FILE cdfr-targets.cmake DESTINATION ${package_folder})
configure_package_config_file(${PROJECT_SOURCE_DIR}/tools/cmake/cdfr-config.cmake.in
  ${PROJECT_BINARY_DIR}/cdfr-config.cmake INSTALL_DESTINATION ${package_folder})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/cdfr-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/cdfr-config.cmake ${PROJECT_BINARY_DIR}/cdfr-config-version.cmake
  DESTINATION ${package_folder})
install(FILES ${PROJECT_SOURCE_DIR}/README.md ${PROJECT_SOURCE_DIR}/LICENSE TYPE DOC)

if(TARGET cdfr_command)
  file(RELATIVE_PATH bin_to_lib ${CMAKE_INSTALL_FULL_BINDIR} ${CMAKE_INSTALL_FULL_LIBDIR})
  set_target_properties(cdfr_command PROPERTIES INSTALL_RPATH "$ORIGIN/${bin_to_lib}")
  install(TARGETS cdfr_command)
endif()
