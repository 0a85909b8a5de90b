# The library for GPUs, in a folder of its own, which the program links. The library of the engine has nothing of CUDA. The compiler is that of CMAKE_CUDA_COMPILER or CUDACXX, that which
# `tools/setup.sh cuda` has fetched, or an installed one. No GPU is needed to compile.
set(fetched_nvcc ${PROJECT_SOURCE_DIR}/build/cuda/nvidia/cu13/bin/nvcc)
if(NOT CMAKE_CUDA_COMPILER AND NOT DEFINED ENV{CUDACXX} AND EXISTS ${fetched_nvcc})
  set(CMAKE_CUDA_COMPILER ${fetched_nvcc} CACHE FILEPATH "Compiler of CUDA")
endif()
# Machine code for A100 and H100, and PTX, of which the driver makes that of later ones.
set(CMAKE_CUDA_ARCHITECTURES "80-real;90" CACHE STRING "GPUs to compile for")
include(CheckLanguage)
check_language(CUDA)
if(NOT CMAKE_CUDA_COMPILER)
  message(FATAL_ERROR "BRINELL_CUDA=ON needs the compiler of CUDA 13: say tools/setup.sh cuda, or set CUDACXX to an nvcc")
endif()
enable_language(CUDA)
if(NOT CMAKE_CUDA20_STANDARD_COMPILE_OPTION) # CMake 3.25 does not know that nvcc has it
  set(CMAKE_CUDA20_STANDARD_COMPILE_OPTION "-std=c++20")
endif()
# CMake looks for libraries in lib64 beside the compiler and then in the system, where those of another CUDA may lie; wheels have lib.
get_filename_component(cuda_root ${CMAKE_CUDA_COMPILER} REALPATH)
cmake_path(GET cuda_root PARENT_PATH cuda_root)
cmake_path(GET cuda_root PARENT_PATH cuda_root)
foreach(library cufft cudart_static)
  find_library(CUDA_${library}_LIBRARY ${library} PATHS ${cuda_root}/lib64 ${cuda_root}/lib NO_DEFAULT_PATH)
endforeach()
find_package(CUDAToolkit 13 REQUIRED)

file(GLOB cuda_sources CONFIGURE_DEPENDS cuda/*.cu)
add_library(brinell_cuda STATIC ${cuda_sources})
set_target_properties(brinell_cuda PROPERTIES CUDA_STANDARD 20 CUDA_STANDARD_REQUIRED ON CUDA_EXTENSIONS OFF UNITY_BUILD OFF)
target_include_directories(brinell_cuda PUBLIC ${PROJECT_SOURCE_DIR} ${PROJECT_SOURCE_DIR}/include PRIVATE ${PROJECT_SOURCE_DIR}/src)
# The mathematics of the engine is compiled for devices, too: kernels may call what is constexpr in the standard library.
target_compile_options(brinell_cuda PRIVATE --expt-relaxed-constexpr -Xcompiler=-Wall,-Wextra,-Wno-unknown-pragmas
  $<$<BOOL:${BRINELL_WERROR}>:-Werror=all-warnings>)
target_link_libraries(brinell_cuda PRIVATE brinell CUDA::cudart_static CUDA::cufft)
# The program and the Python package offer the GPU to cases.
target_link_libraries(brinell_app PRIVATE brinell_cuda)
target_compile_definitions(brinell_app PRIVATE BRINELL_HAS_CUDA)

# For a machine with a GPU: make bench-cuda.
add_executable(brinell_cuda_bench EXCLUDE_FROM_ALL bench/cuda/evaluations.cu)
set_target_properties(brinell_cuda_bench PROPERTIES CUDA_STANDARD 20 CUDA_STANDARD_REQUIRED ON CUDA_EXTENSIONS OFF UNITY_BUILD OFF)
target_include_directories(brinell_cuda_bench PRIVATE src)
target_compile_options(brinell_cuda_bench PRIVATE --expt-relaxed-constexpr -Xcompiler=-Wall,-Wextra,-Wno-unknown-pragmas
  $<$<BOOL:${BRINELL_WERROR}>:-Werror=all-warnings>)
target_link_libraries(brinell_cuda_bench PRIVATE brinell_cuda CUDA::cudart_static CUDA::cufft)
