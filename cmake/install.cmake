# `cmake --install`: the program, the library with its headers, and what CMake and pkg-config need to find it. The Python
# extension is a component of its own (python/bindings).
include(CMakePackageConfigHelpers)

install(TARGETS brinell_program RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT program)
if(BRINELL_MPI)
  install(TARGETS brinell_mpi_program RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT program)
endif()
install(TARGETS brinell EXPORT brinell-targets
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development)
install(DIRECTORY include/brinell DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT development)
install(FILES ${version_header} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/brinell COMPONENT development)

# --- find_package(brinell) --------------------------------------------------------------------------------------------
set(package_directory ${CMAKE_INSTALL_LIBDIR}/cmake/brinell)
set(package_files ${PROJECT_BINARY_DIR}/package)
configure_package_config_file(cmake/brinell-config.cmake.in ${package_files}/brinell-config.cmake
  INSTALL_DESTINATION ${package_directory} NO_SET_AND_CHECK_MACRO NO_CHECK_REQUIRED_COMPONENTS_MACRO)
write_basic_package_version_file(${package_files}/brinell-config-version.cmake COMPATIBILITY SameMinorVersion)
install(EXPORT brinell-targets NAMESPACE brinell:: DESTINATION ${package_directory} COMPONENT development)
install(FILES ${package_files}/brinell-config.cmake ${package_files}/brinell-config-version.cmake
  DESTINATION ${package_directory} COMPONENT development)

# --- pkg-config -------------------------------------------------------------------------------------------------------
# Paths start at the file itself, so that the folder may be moved. HDF5 and toml++ do not come with a .pc file everywhere.
file(RELATIVE_PATH pc_prefix "${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig" "${CMAKE_INSTALL_PREFIX}")
file(RELATIVE_PATH pc_include "${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig" "${CMAKE_INSTALL_FULL_INCLUDEDIR}")
set(pc_requires "fmt >= 9.1, zlib >= 1.2.13")
set(pc_libraries "${OpenMP_CXX_FLAGS}")
pkg_check_modules(PC_TOMLPLUSPLUS QUIET tomlplusplus)
if(PC_TOMLPLUSPLUS_FOUND)
  string(APPEND pc_requires ", tomlplusplus >= 3.3")
endif()
pkg_check_modules(PC_HDF5 QUIET hdf5)
if(PC_HDF5_FOUND)
  string(APPEND pc_requires ", hdf5 >= 1.10.8")
else()
  list(JOIN HDF5_C_LIBRARIES " " hdf5_libraries)
  string(APPEND pc_libraries " ${hdf5_libraries}")
endif()
configure_file(cmake/brinell.pc.in ${package_files}/brinell.pc @ONLY)
install(FILES ${package_files}/brinell.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT development)
