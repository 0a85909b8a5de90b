// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/foundation/error.hpp"
#include "brinell/io/case_file.hpp"
#include "brinell/simulation/indentation.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

/// Boundaries in a case file. What cannot be computed is refused with its line, its key and value, and what is allowed.
namespace brinell::io::periodic_case_test
{

namespace
{

using simulation::IndentationCase;

constexpr const char* flat = R"(shape = {type = "flat"}
)";
constexpr const char* ball = R"(shape = {type = "sphere", radius = "10 mm"}
)";
constexpr const char* cylinder = R"(shape = {type = "cylinder", radius = "10 mm"}
)";
constexpr const char* wavy = R"(shape = {type = "flat"}
texture = {type = "sinusoid", amplitude = "1 um", wavelength_x = "0.5 mm", wavelength_y = "0.5 mm"}
)";

/// A case whose table [grid] begins at line 10, with a drive in line 8.
std::string indentation(const std::string& upper, const std::string& drive, const std::string& grid)
{
  return R"(scenario = "indentation"
[lower]
shape = {type = "flat"}
material = {young_modulus = "200 GPa", poisson_ratio = 0.3}

[indentation]
steps = 2
)" + drive +
         "\n\n[grid]\n" + grid + "\n[upper]\nmaterial.young_modulus = \"200 GPa\"\nmaterial.poisson_ratio = 0.3\n" +
         upper;
}

std::string rolling(const std::string& upper, const std::string& drive, const std::string& grid)
{
  return R"(scenario = "rolling"
[lower]
shape = {type = "flat"}
material = {young_modulus = "200 GPa", poisson_ratio = 0.3}

[rolling]
distance = "2 mm"
)" + drive +
         "\n\n[grid]\n" + grid + "\n[upper]\nmaterial.young_modulus = \"200 GPa\"\nmaterial.poisson_ratio = 0.3\n" +
         upper;
}

std::string refusal(const std::string& text)
{
  try
  {
    static_cast<void>(parse_case(text, "sample.toml", {}));
  }
  catch (const InputError& error)
  {
    return error.what();
  }
  return "not refused";
}

/// The message begins at that line and holds these parts.
void expect_refused(const std::string& text, int line, const std::vector<std::string>& parts)
{
  const std::string message = refusal(text);
  EXPECT_EQ(message.rfind("sample.toml:" + std::to_string(line) + ": ", 0), 0u) << "line " << line << " of\n"
                                                                                << message;
  for (const std::string& part : parts)
    EXPECT_NE(message.find(part), std::string::npos) << part << "\n  in: " << message;
}

constexpr const char* both = "boundary = \"periodic\"\nsize = [\"1 mm\", \"1 mm\"]\n";
constexpr const char* plane = "boundary = [\"open\", \"periodic\"]\n";

TEST(PeriodicCase, WhatIsGoodIsRead)
{
  const auto read = [](const std::string& text)
  { return std::get<IndentationCase>(parse_case(text, "sample.toml", {}).scenario); };
  const IndentationCase rough =
      read(indentation(wavy, "pressure = [\"50 MPa\", 0]", std::string(both) + "cells = [16, 32]"));
  EXPECT_EQ(rough.domain.x, (simulation::Domain::Axis{Boundary::periodic, 1e-3, 16}));
  EXPECT_EQ(rough.domain.y, (simulation::Domain::Axis{Boundary::periodic, 1e-3, 32}));
  EXPECT_DOUBLE_EQ(rough.sequence.front().value, 50.0); // 50 MPa on 1 mm^2
  const IndentationCase line = read(indentation(cylinder, "load = [\"1 MN\", 0]", plane));
  EXPECT_TRUE(simulation::is_plane(simulation::plan(line).contact));
  const IndentationCase in_spacing =
      read(indentation(cylinder, "load = [\"1 MN\", 0]", std::string(plane) + "spacing = [\"50 um\", 1, \"20 um\"]"));
  EXPECT_TRUE(simulation::is_plane(simulation::plan(in_spacing).contact));
}

TEST(PeriodicCase, BoundariesThatAreNone)
{
  expect_refused(indentation(ball, "load = [10]", "boundary = \"closed\""), 11,
                 {"grid.boundary = \"closed\" is not known", "\"open\"", "\"periodic\""});
  expect_refused(indentation(ball, "load = [10]", "boundary = [\"open\", \"closed\"]"), 11,
                 {"has the element \"closed\"", "\"open\", \"periodic\""});
  expect_refused(indentation(ball, "load = [10]", "boundary = [\"open\"]"), 11, {"grid.boundary = [\"open\"]"});
  expect_refused(rolling(ball, "load = 10", "boundary = \"periodic\""), 11,
                 {"grid.boundary = \"periodic\"", "scenario = \"indentation\"", "[\"open\", \"periodic\"]"});
  expect_refused(rolling(ball, "load = 10", "boundary = [\"periodic\", \"open\"]"), 11, {"[\"open\", \"periodic\"]"});
}

TEST(PeriodicCase, KeysThatNeedABoundary)
{
  for (const char* line : {"size = [1, 1]", "cells = [8, 8]", "layer = \"1 um\"", "reference = \"1 mm\""})
  {
    const std::string key = "grid." + std::string(line).substr(0, std::string(line).find(' '));
    expect_refused(indentation(ball, "load = [10]", line), 11,
                   {key, "applies only with grid.boundary", "it is \"open\""});
  }
  expect_refused(
      indentation(wavy, "pressure = [\"1 MPa\"]", std::string(both) + "cells = [8, 8]\nreference = \"1 mm\""), 14,
      {"grid.reference", "applies only with grid.boundary"});
}

TEST(PeriodicCase, ThePeriodAndItsCells)
{
  expect_refused(indentation(wavy, "load = [10]", "boundary = \"periodic\"\ncells = [16, 16]"), 10,
                 {"grid.size is missing", "allowed: two lengths > 0"});
  expect_refused(indentation(wavy, "load = [10]", both), 10, {"grid.cells is missing", "allowed: whole numbers > 0"});
  expect_refused(indentation(wavy, "load = [10]", "boundary = \"periodic\"\nsize = [\"1 mm\", 1, 1]\ncells = [16, 16]"),
                 12, {"has 3 elements; allowed: 2, for each axis that is periodic, or one for all of them"});
  expect_refused(indentation(wavy, "load = [10]", std::string(both) + "cells = [16, 16, 16]"), 13,
                 {"grid.cells = [16, 16, 16] has 3 elements; allowed: 2"});
  expect_refused(indentation(wavy, "load = [10]", std::string(both) + "cells = [16, 16.5]"), 13,
                 {"grid.cells = [16, 16.5] is not a list of whole numbers"});
  expect_refused(indentation(wavy, "load = [10]", std::string(both) + "cells = [16, 0]"), 13, {"grid.cells = [16, 0]"});
  expect_refused(indentation(wavy, "load = [10]", "boundary = \"periodic\"\nsize = [\"1 mm\", 0]\ncells = [16, 16]"),
                 12, {"grid.size"});
}

TEST(PeriodicCase, OneSizeIsThatOfBothAxes)
{
  const auto domain = [](const std::string& grid)
  {
    const Case c = parse_case(indentation(wavy, "load = [10]", "boundary = \"periodic\"\n" + grid), "sample.toml");
    return std::get<simulation::IndentationCase>(c.scenario).domain;
  };
  const simulation::Domain one = domain("size = \"1 mm\"\ncells = 16"),
                           two = domain("size = [1e-3, 1e-3]\ncells = [16, 16]");
  EXPECT_EQ(one.x, two.x);
  EXPECT_EQ(one.y, two.y);
  const std::string rough =
      std::string(flat) + "texture = {type = \"random\", rms_slope = 0.03, cutoff = \"250 um\"}\n";
  EXPECT_NO_THROW(static_cast<void>(parse_case(
      indentation(rough, "load = [10]", "boundary = \"periodic\"\nsize = [\"1 mm\"]\ncells = 32"), "sample.toml")));
}

TEST(PeriodicCase, TheResolvedCaseIsACase)
{
  for (const char* cells : {"cells = [20, 20]", "spacing = [\"50 um\", \"50 um\", \"20 um\"]"})
  {
    const Case c = parse_case(indentation(wavy, "load = [10]", both + std::string(cells)), "sample.toml");
    const std::string text = resolved_text(c.values);
    EXPECT_EQ(resolved_text(parse_case(text, "resolved.toml").values), text);
  }
}

TEST(PeriodicCase, CellsTwice)
{
  const std::string spacing = "spacing = [\"50 um\", \"50 um\", \"20 um\"]\n";
  expect_refused(indentation(wavy, "load = [10]", std::string(both) + spacing + "cells = [20, 20]"), 14,
                 {"grid.cells = [20, 20] cannot stand together with grid.spacing"});
  expect_refused(indentation(wavy, "load = [10]", std::string(both) + spacing + "layer = \"1 um\""), 14,
                 {"grid.layer = \"1 um\" cannot stand together with grid.spacing"});
  expect_refused(indentation(wavy, "load = [10]", std::string(both) + "cells = [20, 20]\nresolution = 8"), 14,
                 {"grid.resolution = 8 applies only with grid.boundary", "allowed: grid.cells or grid.spacing"});
  expect_refused(
      indentation(wavy, "load = [10]", std::string(both) + "spacing = [\"30 um\", \"50 um\", \"20 um\"]"), 12,
      {"grid.size = 0.001 m along x is 33.3333 cells of grid.spacing = 3e-05 m", "allowed: a whole number of cells"});
}

TEST(PeriodicCase, OneCellForWhatIsNotUniform)
{
  expect_refused(indentation(ball, "load = [10]", plane), 10,
                 {"grid.cells is 1 along y", "their shapes vary", "the period along y as grid.size"});
  expect_refused(indentation(R"(shape = {type = "cylinder", radius = "10 mm", length = "5 mm"}
)",
                             "load = [10]", std::string(plane) + "size = [\"8 mm\"]"),
                 12, {"grid.size = 0.008 m along y, in one row, is more than the length of the cylinder, 0.005 m"});
  expect_refused(indentation(wavy, "pressure = [\"1 MPa\"]", std::string(both) + "cells = [16, 1]"), 13,
                 {"grid.cells is 1 along y", "upper.texture varies"});
  expect_refused(indentation(cylinder, "load = [10]", std::string(both) + "cells = [1, 1]"), 13,
                 {"grid.cells = [1, 1]"});
}

TEST(PeriodicCase, TexturesThatDoNotFitThePeriod)
{
  const std::string shape = flat;
  const std::string grid = std::string(both) + "cells = [16, 16]";
  expect_refused(indentation(shape + R"(texture = {type = "sinusoid", amplitude = "1 um", wavelength_x = "2 mm"}
)",
                             "pressure = [\"1 MPa\"]", grid),
                 18, {"upper.texture does not fit the period", "the wavelength of 0.002 m", "0.001 m"});
  expect_refused(indentation(shape + R"(texture = {type = "dent", depth = "1 um", edge_radius = "0.75 mm"}
)",
                             "pressure = [\"1 MPa\"]", grid),
                 18, {"upper.texture does not fit the period", "beyond the period of 0.001 x 0.001 m"});
}

TEST(PeriodicCase, TexturesThatTheCellsDoNotShow)
{
  const std::string shape = flat;
  const std::string texture = R"(texture = {type = "sinusoid", amplitude = "1 um", wavelength_x = "62.5 um"}
)";
  expect_refused(indentation(shape + texture, "pressure = [\"1 MPa\"]", std::string(both) + "cells = [16, 16]"), 13,
                 {"grid.cells: on cells of 6.25e-05 x 6.25e-05 m", "nothing of upper.texture remains"});
}

// Without a size there is no period that a texture could not fit: the default of 1 m is nobody's.
TEST(PeriodicCase, AMissingSizeIsTheOnlyProblem)
{
  const std::string text = indentation(wavy, "pressure = [\"1 MPa\"]", "boundary = \"periodic\"\ncells = [16, 16]");
  try
  {
    static_cast<void>(parse_case(text, "sample.toml", {}));
    FAIL() << "accepted";
  }
  catch (const InputError& error)
  {
    const std::string what = error.what();
    EXPECT_NE(what.find("grid.size is missing"), what.npos) << what;
    EXPECT_EQ(what.find('\n'), what.npos) << what;
  }
}

TEST(PeriodicCase, BodiesThatTouchInNoWay)
{
  const std::string grid = std::string(both) + "cells = [16, 16]";
  expect_refused(indentation(flat, "pressure = [\"1 MPa\"]", grid), 17,
                 {"upper.shape.type = \"flat\"", "are two smooth flats", "allowed with grid.boundary = \"periodic\""});
  expect_refused(indentation(wavy, "load = [10]", std::string(plane) + "size = [\"1 mm\"]\ncells = [16]"), 17,
                 {"upper.shape.type = \"flat\"", "touch neither in a point nor in a line", "allowed: "});
  expect_refused(
      indentation(cylinder, "load = [10]", "boundary = [\"periodic\", \"open\"]\nsize = [\"1 mm\"]\ncells = [16]"), 17,
      {"upper.shape.length is missing", "[\"open\", \"periodic\"]"});
}

TEST(PeriodicCase, DrivesThatHaveNoContact)
{
  const std::string grid = std::string(both) + "cells = [16, 16]";
  expect_refused(indentation(wavy, "approach = [\"0.1 um\", 0]", grid), 8,
                 {"indentation.approach = [\"0.1 um\", 0]", "counts from the mean planes, and at 0 m the",
                  "allowed: a load or mean pressure instead", "indentation.load", "indentation.pressure"});
  expect_refused(indentation(ball, "approach = [\"20 um\"]", grid), 8,
                 {"indentation.approach", "an approach of 2e-05 m cannot be reached",
                  "at 8.35e-06 m the surfaces touch everywhere"}); // 1 mm^2/(12 R), and 1/512 more by the cells
  expect_refused(indentation(wavy, "pressure = [\"1 MPa\"]\nnormalised = true", grid), 9,
                 {"indentation.normalised = true", "not with indentation.pressure"});
  expect_refused(indentation(cylinder, "pressure = [\"1 MPa\"]", plane), 8,
                 {"indentation.pressure = [\"1 MPa\"]", "grid.boundary = \"periodic\"", "indentation.load"});
  expect_refused(indentation(wavy, "pressure = [\"1 MPa\"]\nload = [10]", grid), 8, {"cannot stand together"});
  expect_refused(indentation(wavy, "pressure = [0, 0]", grid), 8, {"never presses the bodies together"});
  expect_refused(indentation(wavy, "pressure = [\"-1 MPa\"]", grid), 8, {"indentation.pressure"});
}

TEST(PeriodicCase, APressureThatYieldsEverything)
{
  const std::string plastic = R"(shape = {type = "flat"}
texture = {type = "sinusoid", amplitude = "1 um", wavelength_x = "0.5 mm"}
material.hardening = {law = "perfect", yield_stress = "400 MPa"}
)";
  expect_refused(indentation(plastic, "pressure = [\"700.5 MPa\", 0]", std::string(both) + "cells = [16, 16]"), 8,
                 {"indentation.pressure = [\"700.5 MPa\", 0]", "the upper body yield to any depth",
                  "allowed: less than 7e+08 Pa"});
}

TEST(PeriodicCase, AReferenceThatNoContactFitsInto)
{
  const std::string grid = std::string(plane) + "reference = \"1 um\"";
  expect_refused(indentation(cylinder, "load = [\"1 MN\", 0]", grid), 12,
                 {"grid.reference = 1e-06 m is less than the half-width of the contact", "allowed: "});
  expect_refused(indentation(cylinder, "approach = [\"1 um\", 0]", grid), 12,
                 {"grid.reference = 1e-06 m", "allowed: "});
  expect_refused(rolling(cylinder, "load = \"1 MN\"", grid), 12, {"grid.reference = 1e-06 m"});
  const std::string tugging = R"(scenario = "tugging"
[tugging]
load = "1 MN"
normalised = false
[lower]
shape = {type = "cylinder", radius = "10 mm"}
material = {young_modulus = "200 GPa", poisson_ratio = 0.3}
[upper]
shape = {type = "cylinder", radius = "10 mm"}
material = {young_modulus = "200 GPa", poisson_ratio = 0.3}
[grid]
boundary = ["open", "periodic"]
)";
  EXPECT_NO_THROW(static_cast<void>(parse_case(tugging, "sample.toml", {})));
  expect_refused(tugging + "reference = \"1 um\"", 13, {"grid.reference = 1e-06 m"});
}

} // namespace

} // namespace brinell::io::periodic_case_test
