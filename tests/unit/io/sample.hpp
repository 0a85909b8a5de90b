// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/error.hpp"
#include "brinell/io/case_file.hpp"
#include "brinell/io/history_csv.hpp"
#include "brinell/simulation/tugging.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <iterator>
#include <string>
#include <unistd.h>

/// A case and results made by hand for the tests of io.
namespace brinell::io::sample
{

inline constexpr std::string_view case_text = R"(scenario = "tugging"
title = "sample"
[lower]
shape = {type = "sphere", radius = "1 m"}
material = {young_modulus = "200 GPa", poisson_ratio = 0.32, hardening = {law = "perfect", yield_stress = "0.9115 GPa"}}
[upper]
shape = {type = "sphere", radius = 2}
material = {young_modulus = 200e9, poisson_ratio = 0.32}
[tugging]
interference = 9
[grid]
spacing = ["3.85 mm", "7.7 mm", "1.925 mm"]
)";

inline Case parsed(const std::vector<std::string>& overrides = {})
{
  return parse_case(case_text, "sample.toml", overrides);
}

inline void expect_message(const std::vector<std::string>& overrides, const std::string& part)
{
  try
  {
    (void)parsed(overrides);
    ADD_FAILURE() << "no error for " << overrides.front();
  }
  catch (const InputError& error)
  {
    EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
  }
}

inline const simulation::TuggingCase& tugging(const Case& c)
{
  return std::get<simulation::TuggingCase>(c.scenario);
}

/// A new folder that goes with the test.
class TemporaryFolder
{
public:
  TemporaryFolder()
  {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    std::string name =
        std::string("brinell-") + test->test_suite_name() + "-" + test->name() + "-" + std::to_string(getpid());
    std::replace(name.begin(), name.end(), '/', '-'); // of parameterised tests
    path_ = std::filesystem::temp_directory_path() / name;
    std::filesystem::remove_all(path_);
    std::filesystem::create_directories(path_);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  ~TemporaryFolder()
  {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

private:
  std::filesystem::path path_;
};

inline std::string file_text(const std::filesystem::path& path)
{
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

inline simulation::TuggingRecord record(int step)
{
  simulation::TuggingRecord r;
  r.step = step;
  r.X = 0.1 * step - 0.3;
  r.F_X = 1.0 / 3.0;
  r.evaluations = 7;
  return r;
}

inline std::vector<NamedNumber> columns(int step)
{
  return io::columns(record(step));
}

/// Values that name their cell: i + 100 j + 10000 k.
inline std::vector<double> numbered(int nx, int ny, int nz)
{
  std::vector<double> values;
  for (int k = 0; k < nz; ++k)
    for (int j = 0; j < ny; ++j)
      for (int i = 0; i < nx; ++i)
        values.push_back(i + 100 * j + 10000 * k);
  return values;
}

inline simulation::BodySnapshot body(bool plastic)
{
  simulation::BodySnapshot b;
  b.grid = {{5, 3, 0.5, 0.25}, 2, 0.125};
  b.x0 = -1.0;
  b.y0 = -0.25;
  b.contact_x = 0.75;
  const auto volume = numbered(5, 3, 2);
  b.stress.fill(std::vector<double>(volume.size(), 0.0));
  b.stress[0] = volume; // uniaxial: the von Mises stress is its amount
  b.residual_displacement = numbered(5, 3, 1);
  if (plastic)
  {
    b.plastic_strain.fill(volume);
    b.equivalent_plastic_strain = volume;
  }
  return b;
}

inline simulation::Snapshot snapshot()
{
  simulation::Snapshot s;
  s.contact = {4, 3, 0.5, 0.25};
  s.x0 = -0.75;
  s.y0 = -0.25;
  s.pressure = numbered(4, 3, 1);
  s.gap.assign(12, 0.5);
  s.lower = body(true);
  s.upper = body(false);
  return s;
}

/// A snapshot as a run gives it to writers.
inline simulation::StepFields fields_of(const simulation::Snapshot& snapshot)
{
  simulation::StepFields fields{.surfaces = snapshot, .lower = {}, .upper = {}};
  for (auto [body, within] :
       {std::pair{&fields.surfaces.lower, &fields.lower}, {&fields.surfaces.upper, &fields.upper}})
  {
    const auto given = [grid = body->grid](std::vector<double>& field)
    { return [grid, field = std::exchange(field, {})] { return LayeredFields(grid, {field}); }; };
    const auto given_tensor = [grid = body->grid](simulation::TensorField& field) {
      return [grid, field = std::exchange(field, {})] { return LayeredFields(grid, {field.begin(), field.end()}); };
    };
    if (!body->equivalent_plastic_strain.empty())
      within->equivalent_plastic_strain = given(body->equivalent_plastic_strain);
    if (!body->temperature.empty())
      within->temperature = given(body->temperature);
    if (!body->plastic_strain[0].empty())
      within->plastic_strain = given_tensor(body->plastic_strain);
    if (!body->stress[0].empty())
      within->stress = given_tensor(body->stress);
  }
  return fields;
}

inline simulation::StepFields fields()
{
  return fields_of(snapshot());
}

} // namespace brinell::io::sample
