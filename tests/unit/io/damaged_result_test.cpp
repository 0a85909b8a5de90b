// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/foundation/error.hpp"
#include "io/files.hpp"
#include "sample_result.hpp"

#include <fmt/format.h>
#include <functional>
#include <gtest/gtest.h>

/// Files of a stopped run that somebody, or a disk, has changed.
namespace brinell::io::damaged_result_test
{

namespace
{

namespace fs = std::filesystem;

/// One step with fields, and a checkpoint after it.
void write_stopped(const fs::path& folder)
{
  ResultDirectory results(folder, sample::parsed(), {});
  results.add(sample::columns(0));
  results.add(0, sample::columns(0), sample::fields());
  results.add_checkpoint(
      [](Archive& archive)
      {
        std::vector<double> field = sample::numbered(5, 3, 2);
        archive("field", field);
      });
}

void flip_bit(const fs::path& file, std::uintmax_t bit)
{
  std::string content = sample::file_text(file);
  content[bit / 8] = static_cast<char>(content[bit / 8] ^ (1 << (bit % 8)));
  std::ofstream(file, std::ios::binary) << content;
}

/// Refused, and named: what is damaged must never be computed with.
void expect_refused(const fs::path& folder, const fs::path& file, const std::string& why = "is damaged")
{
  try
  {
    const ResultDirectory results(folder, sample::parsed(), {}, ResultDirectory::Mode::resume);
    ADD_FAILURE() << file;
  }
  catch (const IoError& error)
  {
    EXPECT_NE(std::string(error.what()).find(fmt::format("{}: {}", file.string(), why)), std::string::npos)
        << error.what();
  }
}

TEST(DamagedResult, EveryDamagedBitIsSeen)
{
  const sample::TemporaryFolder folder;
  write_stopped(folder.path());
  EXPECT_EQ(ResultDirectory(folder.path(), sample::parsed(), {}, ResultDirectory::Mode::resume)
                .take_checkpoint()
                ->at("field"),
            sample::numbered(5, 3, 2));
  for (const char* name : {"checkpoint.h5", "snapshots/000000.h5"})
  {
    const fs::path file = folder.path() / name;
    const std::string whole = sample::file_text(file);
    const std::uintmax_t bits = 8 * whole.size();
    constexpr std::uintmax_t places = 40;
    for (std::uintmax_t i = 0; i < places; ++i)
    {
      flip_bit(file, i * (bits / places) + i % 8);
      expect_refused(folder.path(), file);
      std::ofstream(file, std::ios::binary) << whole;
    }
    std::ofstream(file, std::ios::binary) << whole.substr(0, whole.size() / 2);
    EXPECT_THROW(ResultDirectory(folder.path(), sample::parsed(), {}, ResultDirectory::Mode::resume), IoError) << name;
    std::ofstream(file, std::ios::binary) << whole;
  }
  EXPECT_TRUE(ResultDirectory(folder.path(), sample::parsed(), {}, ResultDirectory::Mode::resume).take_checkpoint());
}

TEST(DamagedResult, HistoryIsRestored)
{
  const sample::TemporaryFolder folder;
  write_stopped(folder.path());
  const fs::path file = folder.path() / "history.csv";
  const std::string whole = sample::file_text(file);
  std::ofstream(file) << "damaged";
  EXPECT_EQ(ResultDirectory(folder.path(), sample::parsed(), {}, ResultDirectory::Mode::resume).finished_steps(), 1);
  EXPECT_EQ(sample::file_text(file), whole);
  fs::remove(file);
  static_cast<void>(ResultDirectory(folder.path(), sample::parsed(), {}, ResultDirectory::Mode::resume));
  EXPECT_EQ(sample::file_text(file), whole);
}

TEST(DamagedResult, DamagedPieceIsNotMergedAndStays)
{
  const sample::TemporaryFolder folder;
  ResultDirectory results(folder.path(), sample::parsed(), {});
  results.add(sample::columns(0));
  results.add(0, sample::columns(0), sample::fields());
  const fs::path piece = folder.path() / "snapshots" / "000000.h5";
  flip_bit(piece, 4 * fs::file_size(piece));
  results.add_final(sample::fields(), sample::columns(0));
  EXPECT_THROW(results.finish("{}"), IoError);
  EXPECT_FALSE(fs::exists(folder.path() / "summary.json"));
  EXPECT_TRUE(fs::exists(piece));
}

TEST(DamagedResult, PieceThatIsGoneIsNamed)
{
  const sample::TemporaryFolder folder;
  write_stopped(folder.path());
  const fs::path piece = folder.path() / "snapshots" / "000000.h5";
  fs::remove(piece);
  expect_refused(folder.path(), piece, "is gone");
}

/// Changes a checkpoint as somebody would who knows how to seal it.
void change_checkpoint(const fs::path& file, const std::function<void(const h5::Handle&)>& change)
{
  const std::string content = sample::file_text(file);
  const std::size_t seal = content.rfind("\nbrinell-checkpoint ");
  std::ofstream(file, std::ios::binary) << content.substr(0, seal);
  {
    const h5::Handle h5(H5Fopen(file.c_str(), H5F_ACC_RDWR, H5P_DEFAULT));
    ASSERT_GE(h5.id(), 0);
    change(h5);
  }
  const std::string image = sample::file_text(file);
  std::ofstream(file, std::ios::binary) << image << "\nbrinell-checkpoint " << checksum(image) << "\n";
}

// A text of fixed length was written over the stack, a number was followed as a pointer.
TEST(DamagedResult, CheckpointIsNotTrusted)
{
  using Change = std::function<void(const h5::Handle&)>;
  const auto without = [](const h5::Handle& file, const char* name) { H5Adelete(file.id(), name); };
  const std::vector<std::pair<const char*, Change>> changes{
      {"program",
       [&](const h5::Handle& f)
       {
         without(f, "program");
         h5::write_fixed_attribute(f, "program", std::string(5000, 'x'));
       }},
      {"program",
       [&](const h5::Handle& f)
       {
         without(f, "program");
         h5::write_attribute(f, "program", 12345);
       }},
      {"program",
       [&](const h5::Handle& f)
       {
         without(f, "program");
         h5::write_attribute(f, "program", std::vector{1.0, 2.0});
       }},
      {"text", [&](const h5::Handle& f) { h5::write_text(f, "text", "no number"); }},
  };
  for (const auto& [what, change] : changes)
  {
    const sample::TemporaryFolder folder;
    write_stopped(folder.path());
    change_checkpoint(folder.path() / "checkpoint.h5", change);
    try
    {
      const ResultDirectory results(folder.path(), sample::parsed(), {}, ResultDirectory::Mode::resume);
      ADD_FAILURE() << what;
    }
    catch (const IoError& error)
    {
      EXPECT_NE(std::string(error.what()).find("checkpoint.h5: is damaged"), std::string::npos) << error.what();
      EXPECT_NE(std::string(error.what()).find(what), std::string::npos) << error.what();
    }
  }
}

} // namespace

} // namespace brinell::io::damaged_result_test
