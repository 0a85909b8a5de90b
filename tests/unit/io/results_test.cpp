// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/foundation/error.hpp"
#include "brinell/io/result_image.hpp"
#include "io/files.hpp"
#include "random_field.hpp"
#include "sample_result.hpp"

#include <array>
#include <cmath>
#include <gtest/gtest.h>

namespace brinell::io::results_test
{

namespace
{

namespace fs = std::filesystem;
using sample::dataset;
using sample::exists;
using sample::numbers_attribute;
using sample::text_attribute;
using sample::text_dataset;
using sample::write_complete;

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

TEST(Results, FieldsDeflatedByAllThreadsHaveTheBytesOfHdf5)
{
  for (const std::array<std::size_t, 3> shape : {std::array<std::size_t, 3>{65, 30, 70}, {2, 3, 5}, {1, 129, 64}})
  {
    const std::size_t cells = shape[0] * shape[1] * shape[2];
    std::vector<double> rough = test::random_field(cells, 1), empty(cells), some = rough;
    std::fill_n(some.begin(), cells / 2, 0.0);
    const VolumeGrid grid{
        {static_cast<int>(shape[2]), static_cast<int>(shape[1]), 1.0, 1.0}, static_cast<int>(shape[0]), 1.0};
    constexpr std::array names{"rough", "empty", "some"};
    const std::array<std::string, 3> texts{"of no order", "nothing", "half of it"};
    const auto write = [&](const h5::Handle& group) {
      h5::write_fields(group, LayeredFields(grid, {rough, empty, some}), names, texts, "Pa", h5::Storage::deflated);
    };
    const h5::Handle file = h5::create_file_in_memory();
    const h5::Handle here = h5::create_group(file, "here"), there = h5::create_group(file, "there");
    write(here);
    for (const std::vector<double>* field : {&rough, &empty, &some})
      h5::write_dataset(there, field == &rough ? "rough" : field == &empty ? "empty" : "some", *field, shape, "Pa", "");
    EXPECT_NO_THROW(h5::require_same_datasets(here, there)) << shape[0];
    EXPECT_NO_THROW(h5::require_same_datasets(there, here)) << shape[0];
    some.back() += 1.0;
    const h5::Handle other = h5::create_group(file, "other");
    write(other);
    EXPECT_THROW(h5::require_same_datasets(here, other), IoError) << "the comparison must tell one number";
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
  ResultImage image(c, {});
  EXPECT_FALSE(image.take_checkpoint().has_value());
  image.add(sample::columns(0));
  image.add(0, sample::columns(0), sample::fields());
  image.add(sample::columns(1));
  image.add_final(sample::fields(), sample::columns(1));
  image.finish("the summary");
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
  ResultDirectory results(folder.path(), sample::parsed(), {});
  simulation::Snapshot snapshot = sample::snapshot();
  std::ranges::fill(snapshot.lower.stress[5], 8.0); // xy
  snapshot.lower.contact_x = -0.25;                 // so that the contact's column 0 is the lower body's
  const fs::path file = folder.path() / "result.vtkhdf";
  for (int step = 0; step < 3; ++step)
  {
    results.add(sample::columns(step));
    snapshot.lower.contact_x += 0.5;
    results.add(step, sample::columns(step), sample::fields_of(snapshot));
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
  ResultDirectory results(folder.path(), sample::parsed(), {});
  for (int step = 0; step < 33; ++step)
  {
    results.add(sample::columns(step));
    results.add(step, sample::columns(step), sample::fields());
  }
  const fs::path file = folder.path() / "result.vtkhdf";
  const auto times = dataset(file, "/VTKHDF/lower_volume/Steps/Values");
  ASSERT_EQ(times.size(), 30u);
  EXPECT_EQ(times.front(), 3.0);
  EXPECT_EQ(times.back(), 32.0);
  EXPECT_TRUE(exists(file, "/steps/000000")) << "all are linked";
  results.add_final(sample::fields(), sample::columns(32));
  results.finish("{}");
  EXPECT_EQ(dataset(file, "/VTKHDF/lower_volume/Steps/Values").size(), 34u);
}

TEST(Results, BodiesThatAreAlikeHaveTheSameFieldsStored)
{
  const sample::TemporaryFolder folder;
  const fs::path one = folder.path() / "one", other = folder.path() / "other";
  simulation::Snapshot snapshot = sample::snapshot();
  const double contact_x = snapshot.upper.contact_x;
  snapshot.upper = snapshot.lower;
  snapshot.upper.contact_x = contact_x;
  const auto write = [&](const fs::path& path, const simulation::StepFields& fields)
  {
    ResultDirectory results(path, sample::parsed(), {});
    results.add(sample::columns(0));
    results.add(0, sample::columns(0), fields);
    results.add_final(fields, sample::columns(0));
    results.finish("{}");
  };
  simulation::StepFields fields = sample::fields_of(snapshot);
  write(one, fields);
  fields.are_alike = true;
  const auto never = []() -> LayeredFields { throw InternalError("computed again"); };
  fields.upper.plastic_strain = fields.upper.stress = never;
  write(other, fields);
  const h5::Handle computed = h5::open_file(one / "result.vtkhdf");
  const h5::Handle copied = h5::open_file(other / "result.vtkhdf");
  for (const char* group : {"/steps/000000", "/final"})
  {
    EXPECT_NO_THROW(h5::require_same_datasets(h5::open_group(computed, group), h5::open_group(copied, group)));
    EXPECT_NO_THROW(h5::require_same_datasets(h5::open_group(copied, group), h5::open_group(computed, group)));
  }
  EXPECT_EQ(text_attribute(other / "result.vtkhdf", "/final/upper/stress/xx", "units"), "Pa");
  EXPECT_EQ(dataset(other / "result.vtkhdf", "/VTKHDF/upper_volume/CellData/stress"),
            dataset(one / "result.vtkhdf", "/VTKHDF/lower_volume/CellData/stress"));
}

TEST(Results, FieldsMustFitTheirGrid)
{
  const sample::TemporaryFolder folder;
  ResultDirectory results(folder.path(), sample::parsed(), {});
  simulation::Snapshot snapshot = sample::snapshot();
  snapshot.pressure.pop_back();
  EXPECT_THROW(results.add(0, sample::columns(0), sample::fields_of(snapshot)), InternalError);
}

} // namespace

} // namespace brinell::io::results_test
