# Extensions of x86-64 that the compiler uses for a processor, by the names that Linux has for them in /proc/cpuinfo; none on
# other processors.
function(processor_features result arch)
  set(${result} "" PARENT_SCOPE)
  set(march)
  if(arch)
    set(march -march=${arch})
  endif()
  execute_process(COMMAND ${CMAKE_CXX_COMPILER} ${march} -dM -E -x c++ /dev/null
    OUTPUT_VARIABLE macros ERROR_QUIET RESULT_VARIABLE status)
  if(NOT status EQUAL 0 OR NOT macros MATCHES "__x86_64__")
    return()
  endif()
  set(found)
  foreach(pair SSE3:pni SSSE3:ssse3 SSE4_1:sse4_1 SSE4_2:sse4_2 POPCNT:popcnt AVX:avx F16C:f16c AVX2:avx2 FMA:fma BMI:bmi1
      BMI2:bmi2 LZCNT:abm MOVBE:movbe AVX512F:avx512f AVX512CD:avx512cd AVX512DQ:avx512dq AVX512BW:avx512bw
      AVX512VL:avx512vl AVX512IFMA:avx512ifma AVX512VBMI:avx512vbmi AVX512VNNI:avx512_vnni)
    string(REPLACE ":" ";" pair ${pair})
    list(GET pair 0 macro)
    list(GET pair 1 name)
    if(macros MATCHES "#define __${macro}__ ")
      list(APPEND found ${name})
    endif()
  endforeach()
  set(${result} ${found} PARENT_SCOPE)
endfunction()
