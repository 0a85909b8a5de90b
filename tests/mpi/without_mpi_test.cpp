// SPDX-License-Identifier: BSD-3-Clause
#include "shared_runs.hpp"

/// The program, the library and the Python package have no trace of MPI.
namespace brinell::mpi_test
{
namespace
{

bool names_mpi(const fs::path& binary)
{
  const std::string text = file_text(binary);
  EXPECT_FALSE(text.empty()) << binary;
  return text.find("MPI_") !=
         std::string::npos; // names of functions that are to be linked, as of messages, are text in it
}

TEST(WithoutMpi, NothingButItsOwnProgramNamesIt)
{
  const fs::path program = BRINELL_PROGRAM, build = program.parent_path().parent_path();
  EXPECT_TRUE(names_mpi(BRINELL_PROGRAM "-mpi"));
  for (const fs::path& binary : {program, build / "libbrinell.a", build / "libbrinell_app.a"})
    EXPECT_FALSE(names_mpi(binary)) << binary;
  if (fs::exists(build / "python" / "bindings")) // the build is that of the Python package, too
    for (const auto& entry : fs::directory_iterator(build / "python" / "bindings"))
      if (entry.path().extension() == ".so")
      {
        EXPECT_FALSE(names_mpi(entry.path())) << entry.path();
      }
}

} // namespace
} // namespace brinell::mpi_test
