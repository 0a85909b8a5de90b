// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/communicator.hpp"
#include <optional>

#include <memory>
#include <string>
#include <vector>

namespace brinell::app
{

/// Exit codes, for scripts.
inline constexpr int exit_ok = 0;
inline constexpr int exit_failure = 1; ///< no convergence, a file that cannot be written, a bug
inline constexpr int exit_input = 2;   ///< command line or case file

struct CaseArguments
{
  std::string file;
  std::vector<std::string> overrides; ///< "key=value"
};

struct CheckArguments
{
  CaseArguments input;
  int ranks = 1, machines = 1;
};

struct RunArguments
{
  CaseArguments input;
  std::string directory; ///< empty: from the case, or results/<name>
  std::string accuracy;  ///< "1%"; empty: as the case says
  std::string device;    ///< "cuda"; empty: as the case says
  int threads = 0;       ///< 0: as OpenMP decides
  bool quiet = false;
  bool resume = false; ///< continue from the last checkpoint
  bool keep = false;   ///< do not replace an earlier result
};

struct SchemaArguments
{
  std::string key; ///< key or table; empty: all
  bool markdown = false;
  bool json = false;
};

struct NewArguments
{
  std::string scenario;
  std::string file; ///< empty: to stdout
  bool force = false;
};

struct CiteArguments
{
  CaseArguments input;
  bool bibtex = false;
};

/// Each returns the exit code and throws the errors of brinell.
/// @param ranks  that compute the case together
[[nodiscard]] int run_command(const RunArguments& arguments, const std::shared_ptr<const Communicator>& ranks);
[[nodiscard]] int check_command(const CheckArguments& arguments);
[[nodiscard]] int schema_command(const SchemaArguments& arguments);
[[nodiscard]] int new_command(const NewArguments& arguments);
[[nodiscard]] int cite_command(const CiteArguments& arguments);

} // namespace brinell::app
