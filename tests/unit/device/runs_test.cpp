// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/device/devices.hpp"
#include "brinell/foundation/error.hpp"
#include "brinell/io/case_file.hpp"
#include "brinell/io/case_template.hpp"
#include "brinell/io/feasibility.hpp"
#include "brinell/io/member_keys.hpp"
#include "brinell/simulation/forecast.hpp"
#include "brinell/simulation/run.hpp"
#include "template_cases.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <string>
#include <variant>
#include <vector>

/// Complete runs on a device, by the processor in its part, against those of the processor.
namespace brinell::device::runs_test
{
namespace
{

using elastoplastic::DeviceChoice;
using simulation::BodySnapshot;
using simulation::Snapshot;

constexpr double tolerance = 1e-10; // what docs/howto/gpu.md tells users

io::Case case_of(const std::string& scenario, std::vector<std::string> overrides = {})
{
  overrides.insert(overrides.begin(), {test::few_cells(scenario), "solver.windows=false"});
  return io::parse_case(io::case_template(scenario), "case.toml", overrides);
}

void expect_same(const std::vector<double>& here, const std::vector<double>& there, const char* what)
{
  ASSERT_EQ(here.size(), there.size()) << what;
  double error = 0.0, largest = 0.0;
  for (std::size_t n = 0; n < here.size(); ++n)
  {
    error = std::max(error, std::abs(here[n] - there[n]));
    largest = std::max(largest, std::abs(there[n]));
  }
  EXPECT_LE(error, tolerance * largest) << what;
}

/// All components of a tensor of a body: some of them are zero but for rounding.
std::vector<double> joined(const std::array<std::vector<double>, 6>& tensors)
{
  std::vector<double> all;
  for (const std::vector<double>& component : tensors)
    all.insert(all.end(), component.begin(), component.end());
  return all;
}

void expect_same_state(const Snapshot& here, const Snapshot& there)
{
  for (const auto& [a, b] : {std::pair{&here.lower, &there.lower}, {&here.upper, &there.upper}})
  {
    expect_same(joined(a->plastic_strain), joined(b->plastic_strain), "plastic strain");
    expect_same(joined(a->stress), joined(b->stress), "stress");
    expect_same(a->equivalent_plastic_strain, b->equivalent_plastic_strain, "equivalent plastic strain");
  }
}

struct Course
{
  std::vector<double> work, pressure, dissipation;
  Snapshot end;
  std::size_t grid_changes = 0;
};

template <typename ScenarioCase>
Course course(ScenarioCase c, const std::vector<DeviceChoice>& devices)
{
  Course all;
  Archive::Fields stored;
  for (std::size_t part = 0; part < devices.size(); ++part)
  {
    c.solver.device = devices[part];
    simulation::Run<ScenarioCase> run(c, {}, part == 0 ? nullptr : &stored);
    const std::size_t end = part + 1 == devices.size() ? 1000000 : 3 * (part + 1);
    while (!run.is_done() && all.work.size() < end)
    {
      const simulation::StepRecord& row = run.step();
      all.work.push_back(row.work);
      all.pressure.push_back(row.max_pressure);
      all.dissipation.push_back(row.dissipation_lower);
    }
    if (part + 1 < devices.size())
      stored = run.checkpoint();
    else
    {
      all.end = run.snapshot();
      all.grid_changes = run.totals().grid_changes.size();
    }
  }
  return all;
}

/// @returns how often the grids have grown
std::size_t expect_same_course(const io::Case& c, const std::vector<DeviceChoice>& devices)
{
  return std::visit(
      [&](const auto& scenario)
      {
        const Course here = course(scenario, devices), there = course(scenario, {DeviceChoice::cpu});
        EXPECT_GT(there.dissipation.back(), 0.0); // it has flowed
        expect_same(here.work, there.work, "work");
        expect_same(here.pressure, there.pressure, "pressure");
        expect_same(here.dissipation, there.dissipation, "dissipation");
        expect_same_state(here.end, there.end);
        EXPECT_EQ(here.grid_changes, there.grid_changes);
        return here.grid_changes;
      },
      c.scenario);
}

TEST(RunOnDevice, EveryScenarioLikeTheProcessor)
{
  for (const std::string& scenario : io::scenario_names())
  {
    SCOPED_TRACE(scenario);
    (void)expect_same_course(case_of(scenario), {DeviceChoice::host});
  }
}

TEST(RunOnDevice, GoesOnElsewhere)
{
  (void)expect_same_course(case_of("tugging"), {DeviceChoice::cpu, DeviceChoice::host, DeviceChoice::cpu});
  (void)expect_same_course(case_of("rolling"), {DeviceChoice::host, DeviceChoice::cpu, DeviceChoice::host});
}

TEST(RunOnDevice, GrowingGrids)
{
  EXPECT_GT(expect_same_course(case_of("tugging", {"grid.extent=0.5", "tugging.interference=9"}), {DeviceChoice::host}),
            0U);
}

std::string refusal(const std::function<void()>& work)
{
  try
  {
    work();
  }
  catch (const InputError& error)
  {
    return io::with_keys(error.what());
  }
  return {};
}

TEST(RunOnDevice, IsRefusedByName)
{
  const std::vector<std::string> layers{
      "lower.material.layers=[{thickness=\"20 um\", young_modulus=\"300 GPa\", poisson_ratio=0.2}]",
      "solver.device=host"};
  const std::string text = refusal([&] { (void)io::plan_case(case_of("indentation", layers)); });
  EXPECT_NE(
      text.find("solver.device = host, and the lower body: a body with layers is not computed on a device; allowed: "
                "cpu or auto"),
      std::string::npos)
      << text;
}

bool has_room(const io::Case& c)
{
  const io::ScenarioPlan plan = io::plan_case(c);
  const auto& p = std::visit([](const auto& any) -> const simulation::Plan& { return any; }, plan);
  return std::visit([&](const auto& scenario) { return simulation::has_device_room(p, scenario, false); }, c.scenario);
}

TEST(RunOnDevice, WithoutCuda)
{
  ASSERT_FALSE(has_cuda()); // the library has none
  const io::Case c = case_of("indentation", {"solver.device=cuda"});
  const std::string report = io::check_report(c, io::plan_case(c));
  EXPECT_NE(report.find("# Device: cuda, "), std::string::npos);
  EXPECT_NE(report.find("built without CUDA and cannot run the case"), std::string::npos);
  const std::string text = refusal([&] { (void)has_room(c); });
  EXPECT_NE(text.find("solver.device = cuda, and this brinell has been built without CUDA"), std::string::npos) << text;
  EXPECT_EQ(opened(DeviceChoice::automatic), nullptr);
}

TEST(RunOnDevice, AutoTakesTheProcessorWhereThereIsNoGpu)
{
  offer_cuda([]() -> std::shared_ptr<const elastoplastic::Device> { throw DeviceError("no GPU is visible"); });
  EXPECT_EQ(opened(DeviceChoice::automatic), nullptr);
  EXPECT_THROW((void)opened(DeviceChoice::cuda), DeviceError);
  offer_cuda({});
}

/// A GPU with little memory.
struct SmallDevice : elastoplastic::Device
{
  [[nodiscard]] std::string name() const override { return "a small GPU"; }
  [[nodiscard]] double free_memory() const override { return 1e6; }
  [[nodiscard]] std::unique_ptr<elastoplastic::BodyOnDevice>
  make_body(const VolumeGrid& /*grid*/, const constitutive::Material& /*material*/, bool /*with_shears*/) const override
  {
    return nullptr;
  }
  [[nodiscard]] std::unique_ptr<contact::ContactOnDevice>
  make_contact(const SurfaceGrid& /*grid*/,
               const halfspace::SurfaceCompliance::NormalSpectra& /*spectra*/) const override
  {
    return nullptr;
  }
};

TEST(RunOnDevice, TellsOfLittleMemoryBeforeItBegins)
{
  offer_cuda([] { return std::make_shared<const SmallDevice>(); });
  std::string text;
  try
  {
    (void)has_room(case_of("indentation", {"solver.device=cuda"}));
  }
  catch (const DeviceError& error)
  {
    text = error.what();
  }
  EXPECT_FALSE(has_room(case_of("indentation", {"solver.device=auto"})));
  offer_cuda({});
  EXPECT_TRUE(has_room(case_of("indentation", {"solver.device=auto"})));
  EXPECT_NE(text.find("GB of its memory, and a small GPU has 0.001 GB left"), std::string::npos) << text;
}

} // namespace
} // namespace brinell::device::runs_test
