# One executable per kind of test, and of unit tests one per floor. The kind is the CTest label: ctest -L unit. A test is
# called kind.Suite.Name or, of a unit test, unit.floor.Suite.Name.
find_package(GTest 1.12 REQUIRED)
find_package(Python3 REQUIRED COMPONENTS Interpreter)
include(GoogleTest)

# Direct sums, random fields, order checks: shared by all kinds.
file(GLOB_RECURSE support_sources CONFIGURE_DEPENDS tests/support/*.cpp)
if(support_sources)
  add_library(brinell_test_support OBJECT ${support_sources})
  set(scope PUBLIC)
  target_link_libraries(brinell_test_support PRIVATE brinell_flags)
else()
  add_library(brinell_test_support INTERFACE)
  set(scope INTERFACE)
endif()
target_include_directories(brinell_test_support ${scope} tests/support)
target_link_libraries(brinell_test_support ${scope} brinell brinell_private_headers GTest::gtest)
target_compile_definitions(brinell_test_support ${scope}
  BRINELL_SOURCE_DIR="${PROJECT_SOURCE_DIR}"
  BRINELL_PROGRAM="${CMAKE_RUNTIME_OUTPUT_DIRECTORY}/brinell")

# CTest runs as many tests at once as there are cores, so each gets one thread; tests of threading ask for more.
function(brinell_add_tests name label timeout)
  if(NOT ARGN)
    return()
  endif()
  string(REPLACE "." "_" target brinell_${name}_tests)
  add_executable(${target} ${ARGN})
  target_link_libraries(${target} PRIVATE
    brinell_test_support brinell brinell_flags GTest::gtest GTest::gtest_main)
  # What takes long in a test is in the library.
  if(BRINELL_SANITIZE)
    target_compile_options(${target} PRIVATE -O1)
  endif()
  # A third of the time of compiling; for the many temporaries of assertions, not for what is tested.
  if(BRINELL_SANITIZE)
    target_compile_options(${target} PRIVATE -fno-sanitize-address-use-after-scope)
  endif()
  gtest_discover_tests(${target}
    DISCOVERY_MODE PRE_TEST
    DISCOVERY_TIMEOUT 60
    NO_PRETTY_VALUES
    WORKING_DIRECTORY ${PROJECT_BINARY_DIR}
    TEST_PREFIX ${name}.
    PROPERTIES LABELS ${label} TIMEOUT ${timeout} ENVIRONMENT OMP_NUM_THREADS=1)
endfunction()

add_custom_target(brinell_unit_tests)
file(GLOB floors CONFIGURE_DEPENDS LIST_DIRECTORIES ON RELATIVE ${PROJECT_SOURCE_DIR}/tests/unit tests/unit/*)
foreach(floor IN LISTS floors)
  file(GLOB_RECURSE unit_tests CONFIGURE_DEPENDS tests/unit/${floor}/*_test.cpp)
  brinell_add_tests(unit.${floor} unit 300 ${unit_tests})
  add_dependencies(brinell_unit_tests brinell_unit_${floor}_tests)
endforeach()
file(GLOB verification_tests CONFIGURE_DEPENDS tests/verification/*.cpp)
file(GLOB regression_tests CONFIGURE_DEPENDS tests/regression/*_test.cpp)
file(GLOB cli_tests CONFIGURE_DEPENDS tests/cli/*_test.cpp)
brinell_add_tests(verification verification 1800 ${verification_tests})
brinell_add_tests(regression regression 1800 ${regression_tests})
brinell_add_tests(cli cli 600 ${cli_tests})
if(BRINELL_MPI)
  file(GLOB mpi_tests CONFIGURE_DEPENDS tests/mpi/*_test.cpp)
  brinell_add_tests(mpi mpi 600 ${mpi_tests})
  add_executable(brinell_mpi_random_cases tests/mpi/random_cases.cpp tests/verification/random_scenarios.cpp)
  target_include_directories(brinell_mpi_random_cases PRIVATE apps)
  target_link_libraries(brinell_mpi_random_cases PRIVATE brinell_mpi brinell_test_support brinell brinell_flags GTest::gtest)
  add_dependencies(brinell_mpi_tests brinell_program brinell_mpi_program brinell_mpi_random_cases)
  foreach(ranks 2 3 4)
    add_test(NAME mpi.RandomCases.OnRanks${ranks} COMMAND
      ${MPIEXEC_EXECUTABLE} ${MPIEXEC_NUMPROC_FLAG} ${ranks} $<TARGET_FILE:brinell_mpi_random_cases>)
    # As in tests/mpi/shared_runs.hpp.
    set_tests_properties(mpi.RandomCases.OnRanks${ranks} PROPERTIES LABELS mpi COST 20 TIMEOUT 1800 ENVIRONMENT
      "OMP_NUM_THREADS=1;OMPI_ALLOW_RUN_AS_ROOT=1;OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1;OMPI_MCA_rmaps_base_oversubscribe=1;OMPI_MCA_mpi_yield_when_idle=1;OMPI_MCA_hwloc_base_binding_policy=none")
  endforeach()
endif()
if(BRINELL_CUDA)
  file(GLOB cuda_tests CONFIGURE_DEPENDS tests/cuda/*_test.cpp)
  add_executable(brinell_cuda_tests ${cuda_tests})
  target_include_directories(brinell_cuda_tests PRIVATE src tests/cuda tests/support)
  target_link_libraries(brinell_cuda_tests PRIVATE brinell_cuda brinell brinell_flags fmt::fmt CUDA::cudart_static GTest::gtest GTest::gtest_main)
  gtest_discover_tests(brinell_cuda_tests DISCOVERY_MODE PRE_TEST TEST_PREFIX cuda. PROPERTIES LABELS cuda TIMEOUT 300)
endif()
# What takes long has a label and begins first. Read by CTest after the tests of the executables, which it finds as it runs.
set_property(DIRECTORY APPEND PROPERTY TEST_INCLUDE_FILES ${PROJECT_SOURCE_DIR}/cmake/long_tests.cmake)
# These run the program. The others can be built without it.
foreach(label regression cli)
  if(TARGET brinell_program AND TARGET brinell_${label}_tests)
    add_dependencies(brinell_${label}_tests brinell_program)
  endif()
endforeach()
if(TARGET brinell_app)
  target_link_libraries(brinell_cli_tests PRIVATE brinell_app)
endif()

add_test(NAME unit.layers COMMAND Python3::Interpreter ${PROJECT_SOURCE_DIR}/tools/check_layers.py)
set_tests_properties(unit.layers PROPERTIES LABELS unit)
add_test(NAME unit.comments COMMAND Python3::Interpreter ${PROJECT_SOURCE_DIR}/tools/check_comments.py)
set_tests_properties(unit.comments PROPERTIES LABELS unit)
add_test(NAME unit.no_cuda COMMAND Python3::Interpreter ${PROJECT_SOURCE_DIR}/tools/check_no_cuda.py
  ${CMAKE_NM} $<TARGET_FILE:brinell> $<$<NOT:$<BOOL:${BRINELL_CUDA}>>:$<TARGET_FILE:brinell_program>>)
set_tests_properties(unit.no_cuda PROPERTIES LABELS unit)
add_test(NAME unit.long COMMAND Python3::Interpreter ${PROJECT_SOURCE_DIR}/tools/check_long_tests.py
  ${CMAKE_CTEST_COMMAND} ${PROJECT_BINARY_DIR})
set_tests_properties(unit.long PROPERTIES LABELS unit)

# Programs whose output is on a page of the developers.
foreach(page one_indentation own_wear_law)
  add_executable(brinell_tour_${page} tests/tour/${page}.cpp)
  target_link_libraries(brinell_tour_${page} PRIVATE brinell brinell_flags)
  add_test(NAME unit.tour.${page} COMMAND Python3::Interpreter ${PROJECT_SOURCE_DIR}/tools/check_tour.py
    $<TARGET_FILE:brinell_tour_${page}>)
  set_tests_properties(unit.tour.${page} PROPERTIES LABELS unit TIMEOUT 300 ENVIRONMENT OMP_NUM_THREADS=1)
endforeach()

# The library as somebody else finds it once it is installed.
if(NOT PROJECT_IS_TOP_LEVEL)
  return() # not installed, see CMakeLists.txt
endif()
if(BRINELL_SANITIZE)
  add_test(NAME package.consumer COMMAND bash -c
    "echo 'Skipped: with sanitizers every program that links the library must be built with them too'; exit 77")
else()
  add_test(NAME package.consumer COMMAND ${PROJECT_SOURCE_DIR}/tests/consumer/check.sh
    ${PROJECT_SOURCE_DIR} ${PROJECT_BINARY_DIR} $<CONFIG> ${CMAKE_CXX_COMPILER} ${CMAKE_GENERATOR})
endif()
add_test(NAME package.wear_law COMMAND ${PROJECT_SOURCE_DIR}/tests/tour/wear_law.sh ${PROJECT_SOURCE_DIR}
  ${CMAKE_CXX_COMPILER} $<TARGET_PROPERTY:GTest::gtest,INTERFACE_INCLUDE_DIRECTORIES>)
set_tests_properties(package.wear_law PROPERTIES LABELS package COST 20 TIMEOUT 600)
set_tests_properties(package.consumer PROPERTIES
  LABELS package COST 60 TIMEOUT 600 PROCESSORS 2 SKIP_RETURN_CODE 77 ENVIRONMENT OMP_NUM_THREADS=1)
