// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/foundation/processor.hpp"

#include "brinell/foundation/error.hpp"

#include <fmt/ranges.h>

#include <cstddef>
#include <cstdlib>
#include <string_view>

#if defined(BRINELL_CHOOSES)
/// Addresses of the functions that a program calls, in the order of the jumps that cmake/join_kernels.py writes.
extern "C"
{
  extern const void* const brinell_functions_v1[];
  extern const void* const brinell_functions_v3[];
  extern const void* const brinell_functions_v4[];
  /// The table in use. It has a value from the start, for what is called before it is chosen.
  extern const void* const* brinell_functions;
  const void* const* brinell_functions = brinell_functions_v1;
}
#endif

namespace brinell
{

namespace
{

constexpr const char* variable = "BRINELL_PROCESSOR";

/// One kind of processor, for which everything that computes is compiled.
struct Kind
{
  const char* name;
  bool (*runs_here)();
#if defined(BRINELL_CHOOSES)
  const void* const* functions;
#endif
};

#if defined(BRINELL_CHOOSES)

// Processors that have these have the other instructions of the kind, too.
bool is_v3()
{
  return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") && __builtin_cpu_supports("bmi2");
}
bool is_v4()
{
  return is_v3() && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512cd") &&
         __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl");
}

constexpr Kind kinds[] = {{"x86-64", [] { return true; }, brinell_functions_v1},
                          {"x86-64-v3", is_v3, brinell_functions_v3},
                          {"x86-64-v4", is_v4, brinell_functions_v4}};

#else

constexpr Kind kinds[] = {{BRINELL_PROCESSOR_NAME, [] { return true; }}};

#endif

/// Kind of processor that the user asks for; nullptr: none.
const char* wish()
{
  const char* value = std::getenv(variable);
  return value == nullptr || *value == '\0' ? nullptr : value;
}

/// The fastest kind that runs here, or the one that the user wishes if it exists and runs here.
const Kind& choose()
{
  const char* wished = wish();
  const Kind* best = kinds;
  for (const Kind& kind : kinds)
    if (kind.runs_here())
    {
      if (wished != nullptr && std::string_view(wished) == kind.name)
        return kind;
      best = &kind;
    }
  return *best;
}

const Kind* chosen = kinds;

/// Before the constructors of other files, which might compute.
[[gnu::constructor(101)]] void set_functions()
{
#if defined(BRINELL_CHOOSES)
  __builtin_cpu_init();
  chosen = &choose();
  brinell_functions = chosen->functions;
#else
  chosen = &choose();
#endif
}

} // namespace

std::vector<std::string> compiled_processors()
{
  std::vector<std::string> names;
  for (const Kind& kind : kinds)
    names.emplace_back(kind.name);
  return names;
}

std::string chosen_processor()
{
  return chosen->name;
}

void require_processor_choice()
{
  if (wish() == nullptr || std::string_view(wish()) == chosen->name)
    return;
  std::vector<std::string> possible;
  for (const Kind& kind : kinds)
    if (kind.runs_here())
      possible.emplace_back(kind.name);
  throw InputError(fmt::format("environment variable {} = \"{}\": here this brinell can use {}", variable, wish(),
                               fmt::join(possible, ", ")));
}

} // namespace brinell
