# Objects of some floors of the library, compiled with one level of optimisation: brinell_<name>.
# Usage: brinell_add_floors(name optimisation floor...)
function(brinell_add_floors name optimisation)
  list(TRANSFORM ARGN REPLACE "(.+)" "${PROJECT_SOURCE_DIR}/src/\\1/*.cpp" OUTPUT_VARIABLE globs)
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${globs})
  add_library(brinell_${name} OBJECT ${sources})
  target_compile_features(brinell_${name} PRIVATE cxx_std_20)
  target_include_directories(brinell_${name} PRIVATE
    ${PROJECT_SOURCE_DIR}/include ${PROJECT_SOURCE_DIR}/src ${PROJECT_BINARY_DIR}/generated ${XXHASH_INCLUDE_DIRS})
  target_compile_options(brinell_${name} PRIVATE $<$<CONFIG:Release>:${optimisation}>)
  target_link_libraries(brinell_${name} PRIVATE
    brinell_flags OpenMP::OpenMP_CXX fmt::fmt PkgConfig::FFTW3 tomlplusplus::tomlplusplus hdf5::hdf5 ZLIB::ZLIB
    Eigen3::Eigen nlohmann_json::nlohmann_json)
endfunction()
