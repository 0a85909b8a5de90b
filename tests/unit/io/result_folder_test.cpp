// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/foundation/error.hpp"
#include "io/files.hpp"
#include "sample_result.hpp"

#include <gtest/gtest.h>

/// What else is in the folder of a result, before, beside and during the run.
namespace brinell::io::result_folder_test
{

namespace
{

namespace fs = std::filesystem;
using sample::dataset;
using sample::write_complete;

// What a process leaves that is killed between two steps: the object is never told that it ends.
TEST(ResultFolder, FinishedStepsAreReadableAtAnyTime)
{
  const sample::TemporaryFolder folder;
  ResultDirectory results(folder.path(), sample::parsed(), {});
  EXPECT_TRUE(fs::exists(folder.path() / "result.vtkhdf"));
  for (int step = 0; step < 3; ++step)
  {
    results.add(sample::columns(step));
    results.add(step, sample::columns(step), sample::fields());
    EXPECT_EQ(dataset(folder.path() / "result.vtkhdf", "/steps/00000" + std::to_string(step) + "/contact/pressure"),
              sample::numbered(4, 3, 1));
    EXPECT_FALSE(fs::exists(folder.path() / "summary.json"));
  }
}

TEST(ResultFolder, EarlierResultGoesBeforeTheNewOneBegins)
{
  const sample::TemporaryFolder folder;
  const Case c = sample::parsed();
  std::ofstream(folder.path() / "notes.txt") << "of the user";
  {
    const ResultDirectory first(folder.path(), c, {});
    EXPECT_FALSE(first.replaced()) << "a file of the user is no result";
  }
  write_complete(folder.path(), c);
  const ResultDirectory again(folder.path(), c, {});
  EXPECT_TRUE(again.replaced());
  EXPECT_FALSE(fs::exists(folder.path() / "summary.json"));
  EXPECT_TRUE(dataset(folder.path() / "result.vtkhdf", "/steps/000000/contact/pressure").empty());
  EXPECT_TRUE(fs::exists(folder.path() / "notes.txt"));
}

// A case may say output.directory = "../..": what lies there need not be of a run.
TEST(ResultFolder, OnlyFilesOfARunAreRemoved)
{
  const sample::TemporaryFolder folder;
  const Case c = sample::parsed();
  for (const char* name : {"summary.json", "history.csv", "result.vtkhdf", "resolved.toml", "checkpoint.h5",
                           "snapshots/000012.h5", "snapshots"})
  {
    const fs::path place = folder.path() / "of-somebody";
    fs::remove_all(place);
    fs::create_directories((place / name).parent_path());
    std::ofstream(place / name) << "mine";
    try
    {
      const ResultDirectory results(place, c, {});
      ADD_FAILURE() << name;
    }
    catch (const InputError& error)
    {
      EXPECT_NE(std::string(error.what()).find(std::string("holds other files: ") + name), std::string::npos)
          << error.what();
    }
    EXPECT_EQ(sample::file_text(place / name), "mine");
    EXPECT_FALSE(fs::exists(place / "history.csv") && std::string(name) != "history.csv") << "nothing is written";
  }
}

TEST(ResultFolder, WhatElseIsBesideTheStoredStepsStays)
{
  const sample::TemporaryFolder folder;
  fs::create_directories(folder.path() / "snapshots" / "holidays");
  std::ofstream(folder.path() / "snapshots" / "2024.txt") << "mine";
  for (int i = 0; i < 2; ++i)
    write_complete(folder.path(), sample::parsed());
  {
    ResultDirectory stopped(folder.path(), sample::parsed(), {});
    stopped.add(sample::columns(0));
    stopped.add(0, sample::columns(0), sample::fields());
  }
  EXPECT_TRUE(fs::exists(folder.path() / "snapshots" / "000000.h5"));
  write_complete(folder.path(), sample::parsed());
  EXPECT_EQ(sample::file_text(folder.path() / "snapshots" / "2024.txt"), "mine");
  EXPECT_TRUE(fs::exists(folder.path() / "snapshots" / "holidays"));
  EXPECT_FALSE(fs::exists(folder.path() / "snapshots" / "000000.h5"));
}

// Also one that is damaged: the others say that it is of a run.
TEST(ResultFolder, DamagedResultIsReplaced)
{
  for (const char* name : {"summary.json", "history.csv", "result.vtkhdf", "resolved.toml"})
  {
    const sample::TemporaryFolder folder;
    write_complete(folder.path(), sample::parsed());
    std::ofstream(folder.path() / name) << "damaged";
    EXPECT_TRUE(ResultDirectory(folder.path(), sample::parsed(), {}).replaced()) << name;
  }
}

TEST(ResultFolder, OneRunPerFolder)
{
  const sample::TemporaryFolder folder;
  const Case c = sample::parsed();
  ResultDirectory first(folder.path(), c, {});
  first.add(sample::columns(0));
  const std::string before = sample::file_text(folder.path() / "history.csv");
  EXPECT_THROW(ResultDirectory(folder.path(), c, {}), IoError);
  EXPECT_EQ(sample::file_text(folder.path() / "history.csv"), before);
}

TEST(ResultFolder, SaysThatItCannotBeWritten)
{
  const sample::TemporaryFolder folder;
  std::ofstream(folder.path() / "file") << "x";
  EXPECT_THROW(ResultDirectory(folder.path() / "file", sample::parsed(), {}), IoError);
  EXPECT_THROW(ResultDirectory(folder.path() / "file" / "below", sample::parsed(), {}), IoError);
  EXPECT_THROW(replace_file("/nowhere/file", "text"), IoError);
}

} // namespace

} // namespace brinell::io::result_folder_test
