// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/foundation/error.hpp"
#include "brinell/io/result_directory.hpp"
#include "brinell/io/result_image.hpp"
#include "brinell/io/summary_json.hpp"
#include "io/files.hpp"
#include "io/results/hdf5.hpp"
#include "sample.hpp"

#include <array>
#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <limits>
#include <nlohmann/json.hpp>
#include <numbers>

namespace brinell::io
{

namespace
{

namespace fs = std::filesystem;

std::vector<double> dataset(const fs::path& file, const std::string& path, std::vector<hsize_t>* shape = nullptr)
{
  const h5::Handle h5 = h5::open_file(file);
  const h5::Handle data(H5Dopen2(h5.id(), path.c_str(), H5P_DEFAULT));
  if (data.id() < 0)
    return {};
  const h5::Handle space(H5Dget_space(data.id()));
  std::vector<double> values(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space.id())));
  H5Dread(data.id(), H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
  if (shape)
  {
    shape->resize(static_cast<std::size_t>(H5Sget_simple_extent_ndims(space.id())));
    H5Sget_simple_extent_dims(space.id(), shape->data(), nullptr);
  }
  return values;
}

std::vector<double> numbers_attribute(const fs::path& file, const std::string& object, const char* name)
{
  const h5::Handle h5 = h5::open_file(file);
  const h5::Handle attribute(H5Aopen_by_name(h5.id(), object.c_str(), name, H5P_DEFAULT, H5P_DEFAULT));
  const h5::Handle space(H5Aget_space(attribute.id()));
  std::vector<double> values(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space.id())));
  H5Aread(attribute.id(), H5T_NATIVE_DOUBLE, values.data());
  return values;
}

std::string text_attribute(const fs::path& file, const std::string& object, const char* name)
{
  const h5::Handle h5 = h5::open_file(file);
  const h5::Handle attribute(H5Aopen_by_name(h5.id(), object.c_str(), name, H5P_DEFAULT, H5P_DEFAULT));
  const h5::Handle type(H5Aget_type(attribute.id()));
  char* data = nullptr;
  H5Aread(attribute.id(), type.id(), &data);
  std::string text = data ? data : "";
  H5free_memory(data);
  return text;
}

std::string text_dataset(const fs::path& file, const std::string& path)
{
  const h5::Handle h5 = h5::open_file(file);
  const h5::Handle data(H5Dopen2(h5.id(), path.c_str(), H5P_DEFAULT));
  const h5::Handle type(H5Dget_type(data.id()));
  char* text = nullptr;
  H5Dread(data.id(), type.id(), H5S_ALL, H5S_ALL, H5P_DEFAULT, &text);
  std::string result = text ? text : "";
  H5free_memory(text);
  return result;
}

bool exists(const fs::path& file, const std::string& path)
{
  return H5Lexists(h5::open_file(file).id(), path.c_str(), H5P_DEFAULT) > 0;
}

simulation::TuggingSummary hand_made_summary(const Case& c)
{
  simulation::TuggingSummary s;
  s.steps = 2;
  s.final_state = sample::snapshot();
  if (c.first_yield)
  {
    s.peak_F_X = 0.25 * c.first_yield->critical.load;
    s.work = 3.0 * c.first_yield->critical.energy;
    s.max_residual_lower = 0.5 * c.first_yield->critical.interference;
  }
  s.X_at_peak_F_X = -0.3;
  s.load_ratio_end = std::nan("");
  return s;
}

void write_complete(const fs::path& folder, const Case& c)
{
  ResultDirectory results(folder, c);
  results.add(sample::columns(0));
  results.add(0, sample::columns(0), sample::snapshot());
  results.add(sample::columns(1));
  const simulation::TuggingSummary summary = hand_made_summary(c);
  results.finish(summary.final_state, sample::columns(1),
                 summary_text(c, simulation::TuggingPlan{}, summary, {.wall_time = 1.5, .threads = 3}));
}

TEST(Results, FieldsAreOrderedAndDescribed)
{
  const sample::TemporaryFolder folder;
  write_complete(folder.path(), sample::parsed());
  const fs::path file = folder.path() / "result.vtkhdf";
  std::vector<hsize_t> shape;
  EXPECT_EQ(dataset(file, "/steps/000000/lower/stress/xx", &shape), sample::numbered(5, 3, 2));
  EXPECT_EQ(shape, (std::vector<hsize_t>{2, 3, 5})); // z, y, x
  EXPECT_EQ(dataset(file, "/steps/000000/contact/pressure", &shape), sample::numbered(4, 3, 1));
  EXPECT_EQ(shape, (std::vector<hsize_t>{3, 4}));
  const auto von_mises = dataset(file, "/final/upper/von_mises_stress"), amount = sample::numbered(5, 3, 2);
  ASSERT_EQ(von_mises.size(), amount.size());
  for (std::size_t i = 0; i < amount.size(); ++i)
    EXPECT_DOUBLE_EQ(von_mises[i], amount[i]); // the stress is uniaxial
  EXPECT_EQ(dataset(file, "/final/lower/plastic_strain/xy"), sample::numbered(5, 3, 2));
  EXPECT_TRUE(dataset(file, "/final/upper/plastic_strain/xy").empty()) << "the body is elastic";
  EXPECT_EQ(numbers_attribute(file, "/final/lower", "spacing"), (std::vector{0.5, 0.25, 0.125}));
  EXPECT_EQ(numbers_attribute(file, "/final/lower", "origin"), (std::vector{-1.0, -0.25, 0.0625}));
  EXPECT_EQ(numbers_attribute(file, "/final/contact", "origin"), (std::vector{-0.75, -0.25}));
  EXPECT_EQ(text_attribute(file, "/final/lower/stress/xx", "units"), "Pa");
  EXPECT_EQ(text_attribute(file, "/final/lower/equivalent_plastic_strain", "units"), "1");
  EXPECT_EQ(text_attribute(file, "/", "format"), "brinell-result");
}

TEST(Results, FieldsTakeThePlaceOfTheirCells)
{
  // Chunks are stored whole: their edges must not lie far beyond those of the field, whatever its shape. What is allowed is a
  // cell per chunk along each axis, and what the file itself takes.
  for (const std::array<std::size_t, 3> shape : {std::array<std::size_t, 3>{65, 65, 65}, {64, 64, 64}, {1, 129, 70}})
  {
    const std::vector<double> values(shape[0] * shape[1] * shape[2], 1.5);
    h5::Handle file = h5::create_file_in_memory();
    h5::write_dataset(file, "field", values, shape, "Pa", "a stress", h5::Storage::plain);
    const double bytes = static_cast<double>(h5::file_image(std::move(file)).size());
    EXPECT_LT(bytes, 1.06 * 8.0 * static_cast<double>(values.size()) + 1e4) << shape[0];
  }
}

TEST(Results, CarryTheirCase)
{
  const sample::TemporaryFolder folder;
  const Case c = sample::parsed();
  write_complete(folder.path(), c);
  EXPECT_EQ(text_dataset(folder.path() / "result.vtkhdf", "/case"), resolved_text(c.values));
  EXPECT_EQ(read_case(folder.path() / "resolved.toml").values.all(), c.values.all());
}

TEST(Results, SummaryIsNormalised)
{
  const sample::TemporaryFolder folder;
  write_complete(folder.path(), sample::parsed());
  const auto json = nlohmann::json::parse(sample::file_text(folder.path() / "summary.json"));
  EXPECT_EQ(json["format_version"], 3);
  EXPECT_EQ(json["complete"], true);
  EXPECT_DOUBLE_EQ(json["normalised"]["peak_F_X"], 0.25);
  EXPECT_DOUBLE_EQ(json["normalised"]["X_over_R_at_peak_F_X"], -0.45); // radii 1 and 2: R = 2/3
  EXPECT_DOUBLE_EQ(json["normalised"]["net_energy"], 3.0);
  EXPECT_DOUBLE_EQ(json["normalised"]["max_residual_lower"], 0.5);
  EXPECT_DOUBLE_EQ(json["normalised"]["interference"], 9.0);
  EXPECT_TRUE(json["load_ratio"]["end"].is_null()) << "a ratio that does not exist";
  EXPECT_EQ(json["critical"]["yields_first"], "lower");
  EXPECT_EQ(json["run"]["threads"], 3);
  EXPECT_EQ(json["case"]["lower"]["material"]["hardening"]["yield_stress"], 0.9115e9);
  EXPECT_EQ(json["case"]["grid"]["spacing"][2], 0.001925);
}

TEST(Results, SummaryTellsInWhatTheBodiesTouch)
{
  const sample::TemporaryFolder folder;
  write_complete(folder.path() / "point", sample::parsed());
  const auto critical = nlohmann::json::parse(sample::file_text(folder.path() / "point" / "summary.json"))["critical"];
  EXPECT_EQ(critical["contact"], "point");
  const double a = critical["contact_radius_m"];
  EXPECT_DOUBLE_EQ(critical["contact_area_m2"], std::numbers::pi * a * a);
  EXPECT_TRUE(critical["line_length_m"].is_null());

  write_complete(folder.path() / "line",
                 sample::parsed({"lower.shape={type=\"cylinder\", radius=1}",
                                 "upper.shape={type=\"cylinder\", radius=1}", "grid.boundary=[\"open\", \"periodic\"]",
                                 "grid.spacing=[\"3.85 mm\", \"50 mm\", \"1.925 mm\"]"}));
  const auto line = nlohmann::json::parse(sample::file_text(folder.path() / "line" / "summary.json"));
  EXPECT_EQ(line["critical"]["contact"], "line");
  EXPECT_EQ(line["critical"]["line_length_m"], 1.0);
  EXPECT_DOUBLE_EQ(line["critical"]["line_reference_m"], 1.0 / std::numbers::e); // 2 R/e, R = 0.5
  EXPECT_DOUBLE_EQ(line["critical"]["contact_area_m2"], 2.0 * line["critical"]["contact_radius_m"].get<double>());
  EXPECT_DOUBLE_EQ(line["normalised"]["peak_F_X"], 0.25);
  EXPECT_DOUBLE_EQ(line["normalised"]["interference"], 9.0);
}

TEST(Results, ElasticSummaryHasNoScales)
{
  const sample::TemporaryFolder folder;
  write_complete(folder.path(), sample::parsed({"lower.material.hardening.law=none", "tugging.normalised=false",
                                                "tugging.interference=1 mm"}));
  const auto json = nlohmann::json::parse(sample::file_text(folder.path() / "summary.json"));
  EXPECT_TRUE(json["critical"]["load_N"].is_null());
  for (const auto& [key, value] : json["normalised"].items())
    EXPECT_TRUE(value.is_null() || key == "X_over_R_at_peak_F_X") << key;
}

// What a process leaves that is killed between two steps: the object is never told that it ends.
TEST(Results, FinishedStepsAreReadableAtAnyTime)
{
  const sample::TemporaryFolder folder;
  ResultDirectory results(folder.path(), sample::parsed());
  EXPECT_TRUE(fs::exists(folder.path() / "result.vtkhdf"));
  for (int step = 0; step < 3; ++step)
  {
    results.add(sample::columns(step));
    results.add(step, sample::columns(step), sample::snapshot());
    EXPECT_EQ(dataset(folder.path() / "result.vtkhdf", "/steps/00000" + std::to_string(step) + "/contact/pressure"),
              sample::numbered(4, 3, 1));
    EXPECT_FALSE(fs::exists(folder.path() / "summary.json"));
  }
}

TEST(Results, EarlierResultGoesBeforeTheNewOneBegins)
{
  const sample::TemporaryFolder folder;
  const Case c = sample::parsed();
  std::ofstream(folder.path() / "notes.txt") << "of the user";
  {
    const ResultDirectory first(folder.path(), c);
    EXPECT_FALSE(first.replaced()) << "a file of the user is no result";
  }
  write_complete(folder.path(), c);
  for (const char* of_version_1 : {"result.h5", "contact.xdmf", "lower.xdmf", "upper.xdmf"})
    std::ofstream(folder.path() / of_version_1) << "of another result";
  const ResultDirectory again(folder.path(), c);
  EXPECT_TRUE(again.replaced());
  EXPECT_FALSE(fs::exists(folder.path() / "result.h5") || fs::exists(folder.path() / "contact.xdmf"));
  EXPECT_FALSE(fs::exists(folder.path() / "summary.json"));
  EXPECT_TRUE(dataset(folder.path() / "result.vtkhdf", "/steps/000000/contact/pressure").empty());
  EXPECT_TRUE(fs::exists(folder.path() / "notes.txt"));
}

// A case may say output.directory = "../..": what lies there need not be of a run.
TEST(Results, OnlyFilesOfARunAreRemoved)
{
  const sample::TemporaryFolder folder;
  const Case c = sample::parsed();
  for (const char* name : {"summary.json", "history.csv", "result.vtkhdf", "resolved.toml", "checkpoint.h5",
                           "result.h5", "contact.xdmf", "snapshots/000012.h5", "snapshots"})
  {
    const fs::path place = folder.path() / "of-somebody";
    fs::remove_all(place);
    fs::create_directories((place / name).parent_path());
    std::ofstream(place / name) << "mine";
    try
    {
      const ResultDirectory results(place, c);
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

TEST(Results, WhatElseIsBesideTheStoredStepsStays)
{
  const sample::TemporaryFolder folder;
  fs::create_directories(folder.path() / "snapshots" / "holidays");
  std::ofstream(folder.path() / "snapshots" / "2024.txt") << "mine";
  for (int i = 0; i < 2; ++i)
    write_complete(folder.path(), sample::parsed());
  {
    ResultDirectory stopped(folder.path(), sample::parsed());
    stopped.add(sample::columns(0));
    stopped.add(0, sample::columns(0), sample::snapshot());
  }
  EXPECT_TRUE(fs::exists(folder.path() / "snapshots" / "000000.h5"));
  write_complete(folder.path(), sample::parsed());
  EXPECT_EQ(sample::file_text(folder.path() / "snapshots" / "2024.txt"), "mine");
  EXPECT_TRUE(fs::exists(folder.path() / "snapshots" / "holidays"));
  EXPECT_FALSE(fs::exists(folder.path() / "snapshots" / "000000.h5"));
}

// Also one that is damaged: the others say that it is of a run.
TEST(Results, DamagedResultIsReplaced)
{
  for (const char* name : {"summary.json", "history.csv", "result.vtkhdf", "resolved.toml"})
  {
    const sample::TemporaryFolder folder;
    write_complete(folder.path(), sample::parsed());
    std::ofstream(folder.path() / name) << "damaged";
    EXPECT_TRUE(ResultDirectory(folder.path(), sample::parsed()).replaced()) << name;
  }
}

/// One step with fields, and a checkpoint after it.
void write_stopped(const fs::path& folder)
{
  ResultDirectory results(folder, sample::parsed());
  results.add(sample::columns(0));
  results.add(0, sample::columns(0), sample::snapshot());
  results.add_checkpoint(0, {{"summary.last.step", {0.0}}, {"field", sample::numbered(5, 3, 2)}});
}

void flip_bit(const fs::path& file, std::uintmax_t bit)
{
  std::string content = sample::file_text(file);
  content[bit / 8] = static_cast<char>(content[bit / 8] ^ (1 << (bit % 8)));
  std::ofstream(file, std::ios::binary) << content;
}

/// Refused, and named: what is damaged must never be computed with.
void expect_refused(const fs::path& folder, const fs::path& file)
{
  try
  {
    const ResultDirectory results(folder, sample::parsed(), ResultDirectory::Mode::resume);
    ADD_FAILURE() << file;
  }
  catch (const IoError& error)
  {
    EXPECT_NE(std::string(error.what()).find(file.string() + ": is damaged"), std::string::npos) << error.what();
  }
}

TEST(Results, EveryDamagedBitIsSeen)
{
  const sample::TemporaryFolder folder;
  write_stopped(folder.path());
  EXPECT_EQ(ResultDirectory(folder.path(), sample::parsed(), ResultDirectory::Mode::resume).checkpoint()->at("field"),
            sample::numbered(5, 3, 2));
  for (const char* name : {"checkpoint.h5", "history.csv", "snapshots/000000.h5"})
  {
    const fs::path file = folder.path() / name;
    const std::string whole = sample::file_text(file);
    const std::uintmax_t bits = 8 * whole.size();
    constexpr std::uintmax_t places = 40;
    for (std::uintmax_t i = 0; i < places; ++i)
    {
      flip_bit(file, i * (bits / places) + i % 8);
      if (std::string(name) == "history.csv") // its header is told apart, a row by what it should have been
        EXPECT_THROW(ResultDirectory(folder.path(), sample::parsed(), ResultDirectory::Mode::resume), IoError) << i;
      else
        expect_refused(folder.path(), file);
      std::ofstream(file, std::ios::binary) << whole;
    }
    std::ofstream(file, std::ios::binary) << whole.substr(0, whole.size() / 2);
    EXPECT_THROW(ResultDirectory(folder.path(), sample::parsed(), ResultDirectory::Mode::resume), IoError) << name;
    std::ofstream(file, std::ios::binary) << whole;
  }
  EXPECT_TRUE(ResultDirectory(folder.path(), sample::parsed(), ResultDirectory::Mode::resume).checkpoint());
}

TEST(Results, DamagedPieceIsNotMergedAndStays)
{
  const sample::TemporaryFolder folder;
  ResultDirectory results(folder.path(), sample::parsed());
  results.add(sample::columns(0));
  results.add(0, sample::columns(0), sample::snapshot());
  const fs::path piece = folder.path() / "snapshots" / "000000.h5";
  flip_bit(piece, 4 * fs::file_size(piece));
  EXPECT_THROW(results.finish(sample::snapshot(), sample::columns(0), "{}"), IoError);
  EXPECT_FALSE(fs::exists(folder.path() / "summary.json"));
  EXPECT_TRUE(fs::exists(piece));
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
TEST(Results, CheckpointIsNotTrusted)
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
      {"step",
       [&](const h5::Handle& f)
       {
         without(f, "step");
         h5::write_attribute(f, "step", "three");
       }},
      {"step",
       [&](const h5::Handle& f)
       {
         without(f, "step");
         h5::write_attribute(f, "step", std::vector{1, 2, 3, 4, 5, 6, 7, 8});
       }},
      {"step",
       [&](const h5::Handle& f)
       {
         without(f, "step");
         h5::write_attribute(f, "step", std::numeric_limits<int>::max());
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
      const ResultDirectory results(folder.path(), sample::parsed(), ResultDirectory::Mode::resume);
      ADD_FAILURE() << what;
    }
    catch (const IoError& error)
    {
      EXPECT_NE(std::string(error.what()).find("checkpoint.h5: is damaged"), std::string::npos) << error.what();
      EXPECT_NE(std::string(error.what()).find(what), std::string::npos) << error.what();
    }
  }
}

TEST(Results, OneRunPerFolder)
{
  const sample::TemporaryFolder folder;
  const Case c = sample::parsed();
  ResultDirectory first(folder.path(), c);
  first.add(sample::columns(0));
  const std::string before = sample::file_text(folder.path() / "history.csv");
  EXPECT_THROW(ResultDirectory(folder.path(), c), IoError);
  EXPECT_EQ(sample::file_text(folder.path() / "history.csv"), before);
}

TEST(Results, OneFileHoldsAll)
{
  const sample::TemporaryFolder folder;
  write_complete(folder.path(), sample::parsed());
  const fs::path file = folder.path() / "alone" / "moved.vtkhdf";
  fs::create_directories(file.parent_path());
  fs::rename(folder.path() / "result.vtkhdf", file);
  EXPECT_EQ(text_dataset(file, "/summary"), sample::file_text(folder.path() / "summary.json"));
  EXPECT_EQ(dataset(file, "/history/step"), (std::vector{0.0, 1.0}));
  EXPECT_EQ(dataset(file, "/history/X"), (std::vector{sample::record(0).X, sample::record(1).X}));
  for (const auto& column : sample::columns(0))
    EXPECT_TRUE(exists(file, std::string("/history/").append(column.name))) << column.name;
  EXPECT_EQ(text_attribute(file, "/history/F_X", "units"), "N");
  EXPECT_EQ(text_attribute(file, "/history/theta", "units"), "rad");
  EXPECT_FALSE(dataset(file, "/final/contact/gap").empty());
  EXPECT_EQ(dataset(file, "/VTKHDF/lower_volume/CellData/von_mises_stress").size(),
            2 * sample::numbered(5, 3, 2).size());
}

TEST(Results, InMemoryAreTheSameFields)
{
  const sample::TemporaryFolder folder;
  const Case c = sample::parsed();
  write_complete(folder.path(), c);
  ResultImage image(c);
  EXPECT_FALSE(image.checkpoint().has_value());
  image.add(sample::columns(0));
  image.add(0, sample::columns(0), sample::snapshot());
  image.add(sample::columns(1));
  image.finish(sample::snapshot(), sample::columns(1), "the summary");
  const fs::path memory = folder.path() / "memory.vtkhdf", disk = folder.path() / "result.vtkhdf";
  replace_file(memory, std::move(image).bytes());
  EXPECT_EQ(text_dataset(memory, "/summary"), "the summary");
  EXPECT_EQ(text_dataset(memory, "/case"), text_dataset(disk, "/case"));
  for (const char* name : {"/history/X", "/history/step", "/final/contact/gap", "/steps/000000/lower/stress/xz",
                           "/steps/000000/lower/von_mises_stress", "/final/upper/residual_displacement"})
  {
    EXPECT_FALSE(dataset(memory, name).empty()) << name;
    EXPECT_EQ(dataset(memory, name), dataset(disk, name)) << name;
  }
}

// That VTK itself reads it, the tests in Python show.
TEST(Results, VtkhdfShowsAllStatesOnOneAxis)
{
  const sample::TemporaryFolder folder;
  ResultDirectory results(folder.path(), sample::parsed());
  simulation::Snapshot snapshot = sample::snapshot();
  std::ranges::fill(snapshot.lower.stress[5], 8.0); // xy
  snapshot.lower.contact_x = -0.25;                 // so that the contact's column 0 is the lower body's
  const fs::path file = folder.path() / "result.vtkhdf";
  for (int step = 0; step < 3; ++step)
  {
    results.add(sample::columns(step));
    snapshot.lower.contact_x += 0.5;
    results.add(step, sample::columns(step), snapshot);
    std::vector<hsize_t> shape;
    const auto stress = dataset(file, "/VTKHDF/lower_volume/CellData/stress", &shape);
    if (step == 0) // without an axis of time
    {
      EXPECT_EQ(shape, (std::vector<hsize_t>{2, 3, 5, 6}));
      continue;
    }
    const hsize_t count = step + 1;
    EXPECT_EQ(shape, (std::vector<hsize_t>{count, 2, 3, 5, 6}));
    EXPECT_EQ(stress[stress.size() - 6], 10204.0); // xx of the last cell
    EXPECT_EQ(stress[stress.size() - 3], 8.0);     // VTK has xy in fourth place
    const auto pressure = dataset(file, "/VTKHDF/lower_surface/PointData/pressure", &shape);
    EXPECT_EQ(shape, (std::vector<hsize_t>{count, 3, 5}));
    EXPECT_EQ(std::vector(pressure.end() - 5, pressure.end()),
              step == 1 ? (std::vector{0.0, 0.0, 200.0, 201.0, 202.0}) : (std::vector{0.0, 0.0, 0.0, 200.0, 201.0}));
    EXPECT_TRUE(std::isnan(dataset(file, "/VTKHDF/lower_surface/PointData/gap").back()) == false);
    EXPECT_TRUE(std::isnan(dataset(file, "/VTKHDF/lower_surface/PointData/gap").front()));
  }
  EXPECT_EQ(dataset(file, "/VTKHDF/upper_volume/Steps/Values"), (std::vector{0.0, 1.0, 2.0}));
  EXPECT_EQ(numbers_attribute(file, "/VTKHDF/lower_volume", "Origin"), (std::vector{-1.25, -0.375, 0.0}));
  EXPECT_EQ(numbers_attribute(file, "/VTKHDF/lower_volume", "WholeExtent"),
            (std::vector{0.0, 5.0, 0.0, 3.0, 0.0, 2.0}));
  EXPECT_EQ(numbers_attribute(file, "/VTKHDF/lower_surface", "Origin"), (std::vector{-1.0, -0.25, 0.0}));
  EXPECT_TRUE(exists(file, "/VTKHDF/lower_volume/CellData/plastic_strain"));
  EXPECT_FALSE(exists(file, "/VTKHDF/upper_volume/CellData/plastic_strain")) << "the body is elastic";
}

// Written anew for each of them, it would cost ever more.
TEST(Results, UnfinishedFileShowsTheNewestStates)
{
  const sample::TemporaryFolder folder;
  ResultDirectory results(folder.path(), sample::parsed());
  for (int step = 0; step < 33; ++step)
  {
    results.add(sample::columns(step));
    results.add(step, sample::columns(step), sample::snapshot());
  }
  const fs::path file = folder.path() / "result.vtkhdf";
  const auto times = dataset(file, "/VTKHDF/lower_volume/Steps/Values");
  ASSERT_EQ(times.size(), 30u);
  EXPECT_EQ(times.front(), 3.0);
  EXPECT_EQ(times.back(), 32.0);
  EXPECT_TRUE(exists(file, "/steps/000000")) << "all are linked";
  results.finish(sample::snapshot(), sample::columns(32), "{}");
  EXPECT_EQ(dataset(file, "/VTKHDF/lower_volume/Steps/Values").size(), 34u);
}

TEST(Results, FieldsMustFitTheirGrid)
{
  const sample::TemporaryFolder folder;
  ResultDirectory results(folder.path(), sample::parsed());
  simulation::Snapshot snapshot = sample::snapshot();
  snapshot.pressure.pop_back();
  EXPECT_THROW(results.add(0, sample::columns(0), snapshot), InternalError);
}

TEST(Results, SaysThatItCannotBeWritten)
{
  const sample::TemporaryFolder folder;
  std::ofstream(folder.path() / "file") << "x";
  EXPECT_THROW(ResultDirectory(folder.path() / "file", sample::parsed()), IoError);
  EXPECT_THROW(ResultDirectory(folder.path() / "file" / "below", sample::parsed()), IoError);
  EXPECT_THROW(replace_file("/nowhere/file", "text"), IoError);
}

} // namespace

} // namespace brinell::io
