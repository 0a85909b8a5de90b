# Objects of some floors of the library, all compiled with one level of optimisation.
# Usage: brinell_add_floors(target optimisation floor...)
function(brinell_add_floors target optimisation)
  list(TRANSFORM ARGN REPLACE "(.+)" "${PROJECT_SOURCE_DIR}/src/\\1/*.cpp" OUTPUT_VARIABLE globs)
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${globs})
  list(REMOVE_ITEM sources ${PROJECT_SOURCE_DIR}/src/foundation/processor.cpp) # compiled once, below
  add_library(${target} OBJECT ${sources})
  target_compile_features(${target} PRIVATE cxx_std_20)
  target_include_directories(${target} PRIVATE
    ${PROJECT_SOURCE_DIR}/include ${PROJECT_SOURCE_DIR}/src ${PROJECT_BINARY_DIR}/generated ${XXHASH_INCLUDE_DIRS})
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:${optimisation}>)
  target_link_libraries(${target} PRIVATE
    brinell_flags OpenMP::OpenMP_CXX fmt::fmt PkgConfig::FFTW3 tomlplusplus::tomlplusplus hdf5::hdf5 ZLIB::ZLIB
    Eigen3::Eigen nlohmann_json::nlohmann_json)
endfunction()

# Objects of floors that are compiled for several kinds of processor and joined by join_kernels.py: their files are listed in the
# variable `result`. Usage: brinell_add_floors_for_all_processors(result optimisation floor...)
function(brinell_add_floors_for_all_processors result optimisation)
  find_package(Python3 REQUIRED COMPONENTS Interpreter)
  set(folder ${PROJECT_BINARY_DIR}/kernels)
  set(arguments)
  set(objects)
  set(outputs ${folder}/kernels_jumps.o)
  foreach(kind v1=x86-64 v3=x86-64-v3 v4=x86-64-v4)
    string(REPLACE "=" ";" kind ${kind})
    list(GET kind 0 name)
    list(GET kind 1 arch)
    set(target brinell_numerics_${name})
    brinell_add_floors(${target} ${optimisation} ${ARGN})
    # Without unique symbols all names can be made local.
    target_compile_options(${target} PRIVATE -march=${arch} -fno-gnu-unique)
    list(APPEND arguments --kind ${name} $<TARGET_OBJECTS:${target}>)
    list(APPEND objects $<TARGET_OBJECTS:${target}>)
    list(APPEND outputs ${folder}/kernels_${name}.o)
  endforeach()
  set(script ${PROJECT_SOURCE_DIR}/cmake/join_kernels.py)
  add_custom_command(OUTPUT ${outputs}
    COMMAND Python3::Interpreter ${script} --to ${folder} --nm ${CMAKE_NM} --ld ${CMAKE_LINKER} --objcopy ${CMAKE_OBJCOPY}
            --compiler ${CMAKE_CXX_COMPILER} ${arguments}
    DEPENDS ${objects} ${script} VERBATIM COMMAND_EXPAND_LISTS)
  set_source_files_properties(${outputs} PROPERTIES EXTERNAL_OBJECT ON GENERATED ON)
  set(${result} ${outputs} PARENT_SCOPE)
endfunction()
