# cmake -D source=... -D output=... -P write_version.cmake
# Writes brinell/version.hpp; leaves the file untouched if nothing changed, so that nothing is rebuilt.
file(STRINGS "${source}/VERSION" version LIMIT_COUNT 1)
set(git_hash "unknown")
if(EXISTS "${source}/.git")
  execute_process(
    COMMAND git -C "${source}" describe --always --dirty --abbrev=12 --exclude=*
    OUTPUT_VARIABLE described OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE failed)
  if(NOT failed AND described)
    set(git_hash "${described}")
  endif()
endif()
configure_file("${source}/cmake/version.hpp.in" "${output}" @ONLY)
