# Included by CTest when it runs: tests/long_tests.txt gives label and cost. What costs most begins first, so that no core is
# left alone with it at the end. Names that are no tests are passed over here; tools/check_long_tests.py finds them.
file(STRINGS ${CMAKE_CURRENT_LIST_DIR}/../tests/long_tests.txt long_tests REGEX "^[a-z]")
foreach(line IN LISTS long_tests)
  string(REGEX MATCH "^(([a-z]+)[^ ]*) +([0-9.]+)$" matched "${line}")
  set_tests_properties(${CMAKE_MATCH_1} PROPERTIES COST ${CMAKE_MATCH_3} LABELS "${CMAKE_MATCH_2};long")
endforeach()
