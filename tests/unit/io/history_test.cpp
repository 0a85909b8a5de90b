// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/foundation/error.hpp"
#include "brinell/io/history_csv.hpp"
#include "sample.hpp"

#include <cstdlib>
#include <gtest/gtest.h>
#include <sstream>

namespace brinell::io::history_test
{

namespace
{

TEST(History, HeaderIsTheSpecifiedOne)
{
  EXPECT_EQ(history_header(sample::columns(0)),
            "step,pass,X,theta,interference,height,contact_area,max_pressure,F_n,F_X,F_Y,"
            "F_Z,F_X_macro,F_Z_macro,F_friction,share_at_shear_limit,max_temperature_lower,max_temperature_upper,"
            "heat_lower,heat_upper,heat_of_source,heat_of_current,heat_of_plastic_work,work_of_expansion,"
            "worn_volume_lower,worn_volume_upper,max_worn_depth_lower,max_worn_depth_upper,max_wear_step,work_of_wear,"
            "contact_resistance,current,voltage,electric_power,max_current_density,current_spots,largest_spot_share,"
            "contact_temperature,film_resistance,min_contact_resistance,max_contact_temperature,"
            "thermal_contact_conductance,work,dissipation_lower,"
            "dissipation_upper,dissipation_friction,energy_residual,energy_elastic,max_residual_lower,"
            "max_residual_upper,max_equivalent_plastic_strain,"
            "evaluations");
}

TEST(History, NumbersReadBackTheSame)
{
  simulation::TuggingRecord record = sample::record(4);
  record.work = 1e-300 / 3.0;
  std::istringstream row(history_row(columns(record)));
  std::vector<std::string> cells;
  for (std::string cell; std::getline(row, cell, ',');)
    cells.push_back(cell);
  ASSERT_EQ(cells.size(), 52u);
  EXPECT_EQ(cells.front(), "4");
  EXPECT_EQ(std::strtod(cells[2].c_str(), nullptr), record.X);
  EXPECT_EQ(std::strtod(cells[9].c_str(), nullptr), 1.0 / 3.0);
  EXPECT_EQ(std::strtod(cells[42].c_str(), nullptr), record.work);
  EXPECT_EQ(cells.back(), "7");
}

TEST(History, RowsAreThereBeforeTheFileIsClosed)
{
  const sample::TemporaryFolder folder;
  HistoryWriter writer(folder.path() / "history.csv", sample::columns(0));
  writer.add(sample::columns(0));
  EXPECT_EQ(sample::file_text(folder.path() / "history.csv"),
            history_header(sample::columns(0)) + "\n" + history_row(sample::columns(0)) + "\n");
}

TEST(History, GoesOnAfterTheRowsOfTheCheckpoint)
{
  const sample::TemporaryFolder folder;
  const auto path = folder.path() / "history.csv";
  Archive checkpoint;
  std::string all;
  {
    HistoryWriter writer(path, sample::columns(0));
    writer.add(sample::columns(0));
    writer.add(sample::columns(1));
    checkpoint("history", writer);
    writer.add(sample::columns(2));
    all = sample::file_text(path);
  }
  std::ofstream(path) << "damaged";
  HistoryWriter resumed(path, sample::columns(0), &checkpoint.fields());
  EXPECT_EQ(sample::file_text(path), all.substr(0, all.find("\n2,") + 1));
  EXPECT_EQ(resumed.columns()[0].values, (std::vector{0.0, 1.0}));
  EXPECT_EQ(resumed.columns()[2].values, (std::vector{sample::record(0).X, sample::record(1).X}));
  EXPECT_TRUE(resumed.columns()[0].is_integer);
  EXPECT_FALSE(resumed.columns()[2].is_integer);
  resumed.add(sample::columns(2));
  EXPECT_EQ(sample::file_text(path), all);
}

TEST(History, RefusesACheckpointWithOtherRows)
{
  const sample::TemporaryFolder folder;
  const auto path = folder.path() / "history.csv";
  HistoryWriter writer(path, sample::columns(0));
  writer.add(sample::columns(0));
  Archive checkpoint;
  checkpoint("history", writer);
  for (const char* name : {"history.X", "history.X.size"})
  {
    Archive::Fields fields = checkpoint.fields();
    fields.erase(name);
    EXPECT_THROW(HistoryWriter(path, sample::columns(0), &fields), InputError) << name;
  }
  Archive::Fields fields = checkpoint.fields();
  fields["history.X"] = {1.0, 2.0};
  fields["history.X.size"] = {2.0};
  EXPECT_THROW(HistoryWriter(path, sample::columns(0), &fields), InputError);
}

TEST(History, SaysThatItCannotBeWritten)
{
  EXPECT_THROW(HistoryWriter("/nowhere/history.csv", sample::columns(0)), IoError);
}

} // namespace

} // namespace brinell::io::history_test
