// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/foundation/error.hpp"
#include "brinell/io/units.hpp"

#include <gtest/gtest.h>
#include <numbers>

namespace brinell::io::units_test
{

namespace
{

struct Good
{
  const char* text;
  double value;
  Dimension dimension;
};

class GoodQuantity : public testing::TestWithParam<Good>
{
};

// Bit for bit: the power of ten of the unit goes into the decimal number, not into a product.
TEST_P(GoodQuantity, IsExact)
{
  const Quantity q = quantity(GetParam().text);
  EXPECT_EQ(q.value, GetParam().value);
  EXPECT_EQ(q.dimension, GetParam().dimension);
}

INSTANTIATE_TEST_SUITE_P(
    Units, GoodQuantity,
    testing::Values(Good{"3.85 mm", 0.00385, dimension::length}, Good{"1.925mm", 0.001925, dimension::length},
                    Good{"200 GPa", 200e9, dimension::pressure}, Good{"0.9115 GPa", 0.9115e9, dimension::pressure},
                    Good{"911.5 N/mm^2", 911.5e6, dimension::pressure},
                    Good{"911.5 N/mm2", 911.5e6, dimension::pressure},
                    Good{"911.5 N*mm^-2", 911.5e6, dimension::pressure}, Good{"7 N/mm\u00b2", 7e6, dimension::pressure},
                    Good{"1\u00a0mm", 1e-3, dimension::length}, Good{"\u22121\u202fmm", -1e-3, dimension::length},
                    Good{"2\u2009MPa", 2e6, dimension::pressure}, Good{"3 \u00c5", 3e-10, dimension::length},
                    Good{"2 um", 2e-6, dimension::length}, Good{"2 \u00b5m", 2e-6, dimension::length},
                    Good{"2 \u03bcm", 2e-6, dimension::length}, Good{"7 nm", 7e-9, dimension::length},
                    Good{"1e3 m", 1e3, dimension::length}, Good{"-1.5E-2 km", -15.0, dimension::length},
                    Good{"+.5 cm", 0.005, dimension::length}, Good{" 4  m ", 4.0, dimension::length},
                    Good{"3 bar", 3e5, dimension::pressure}, Good{"0.3", 0.3, dimension::none},
                    Good{"5 %", 0.05, dimension::none}, Good{"2 N m", 2.0, {.mass = 1, .length = 2, .time = -2}},
                    Good{"2 kN\u00b7m", 2e3, {.mass = 1, .length = 2, .time = -2}},
                    Good{"45 W/m/K", 45.0, {.mass = 1, .length = 1, .time = -3, .temperature = -1}},
                    Good{"45 W/(m K)", 45.0, dimension::conductivity},
                    Good{"45W / ( m*K )", 45.0, dimension::conductivity},
                    Good{"0.46 kJ/(kg\u00b7K)", 460.0, dimension::specific_heat},
                    Good{"1e-6 mm^3/(N m)", 1e-15, dimension::wear}, Good{"2e-15 1/Pa", 2e-15, dimension::wear},
                    Good{"3e-4 mm^3/J", 3e-13, dimension::wear}, Good{"2e-15 m^2/N", 2e-15, dimension::wear},
                    Good{"12e-6 1/K", 12e-6, dimension::expansion}, Good{"12e-6/K", 12e-6, dimension::expansion},
                    Good{"12 um/m/K", 12e-6, dimension::expansion}, Good{"12 um/(m K)", 12e-6, dimension::expansion},
                    Good{"7850 kg/m^3", 7850.0, dimension::density}, Good{"3 ms", 3e-3, {.time = 1}}));

TEST(Units, OfOldAndOtherCountriesHaveTheirExactFactors)
{
  EXPECT_EQ(quantity("1 in").value, 0.0254);
  EXPECT_DOUBLE_EQ(quantity("0.375 inch").value, 0.009525); // a product of two numbers, rounded once
  EXPECT_EQ(quantity("2 angstrom").value, 2e-10);
  EXPECT_EQ(quantity("2 \u00c5").value, 2e-10);
  EXPECT_DOUBLE_EQ(quantity("10 kgf").value, 98.0665);
  EXPECT_DOUBLE_EQ(quantity("720 HV").value, 720.0 * 9.80665e6);
  EXPECT_DOUBLE_EQ(quantity("720 kgf/mm^2").value, quantity("720 HV").value);
  EXPECT_EQ(quantity("720 HV").dimension, dimension::pressure);
  EXPECT_DOUBLE_EQ(quantity("3 in/s").value, 0.0762);
  EXPECT_DOUBLE_EQ(quantity("2 in^2").value, 2.0 * 0.0254 * 0.0254);
  EXPECT_THROW((void)quantity("3 kin"), InputError); // no prefixes, which might mean something else
  EXPECT_THROW((void)quantity("3 min"), InputError);
}

TEST(Units, ATemperatureIsReadFromItsOwnZero)
{
  EXPECT_EQ(degrees_celsius("20 degC"), 20.0);
  EXPECT_EQ(degrees_celsius("-5.5\u00b0C"), -5.5);
  EXPECT_DOUBLE_EQ(degrees_celsius(" 1e3 K "), 726.85);
  EXPECT_DOUBLE_EQ(degrees_celsius("0 K"), -273.15);
  for (const char* bad : {"", "20", "20 C", "20 mK", "degC", "20 K/m", "nan degC"})
    EXPECT_THROW((void)degrees_celsius(bad), InputError) << bad;
}

TEST(Units, AnglesAreInDegrees)
{
  EXPECT_EQ(degrees("70.3 deg"), 70.3);
  EXPECT_EQ(degrees("-70.3°"), -70.3);
  EXPECT_DOUBLE_EQ(degrees("0.5 rad"), 90.0 / std::numbers::pi);
  EXPECT_DOUBLE_EQ(degrees("500 mrad"), degrees("0.5 rad"));
  EXPECT_DOUBLE_EQ(quantity("5 mrad/mm").value, 5.0);
  for (const char* bad : {"", "20", "rad", "20 deg/mm", "nan deg", "20 urad", "20 mm"})
    EXPECT_THROW((void)degrees(bad), InputError) << bad;
}

TEST(Units, FrequenciesAreInHertz)
{
  EXPECT_EQ(quantity("50 Hz").dimension, (Dimension{.time = -1}));
  EXPECT_DOUBLE_EQ(quantity("2 kHz").value, 2000.0);
  EXPECT_DOUBLE_EQ(quantity("2 1/ms").value, 2000.0);
}

class BadQuantity : public testing::TestWithParam<const char*>
{
};

TEST_P(BadQuantity, IsRefused)
{
  EXPECT_THROW((void)quantity(GetParam()), InputError) << GetParam();
}

INSTANTIATE_TEST_SUITE_P(Units, BadQuantity,
                         testing::Values("", "mm", "3.85 furlong", "3 mm/", "3 mm^", "3 mm^x", "3..5 m", "1,5 mm",
                                         "nan m", "inf m", "0x10 m", "3 m m^99", "1e999 m", "1e99999 m", "1e m", "- m",
                                         "3 k%", "3 W/(m/K)", "3 W/(m K", "3 W/()", "3 (m K)", "3 2/K", "3 *K"));

TEST(Units, SayWhatIsMeantBySmallAndCapitalLetters)
{
  const auto message = [](const char* text)
  {
    try
    {
      (void)quantity(text);
    }
    catch (const InputError& error)
    {
      return std::string(error.what());
    }
    return std::string("no error");
  };
  EXPECT_NE(message("210 Gpa").find("did you mean GPa?"), std::string::npos) << message("210 Gpa");
  EXPECT_NE(message("900 mpa").find("did you mean MPa or mPa?"), std::string::npos) << message("900 mpa");
  EXPECT_NE(message("5 n/mm^2").find("did you mean N?"), std::string::npos) << message("5 n/mm^2");
  EXPECT_EQ(message("3 furlong").find("did you mean"), std::string::npos);
  EXPECT_NE(message("3 furlong").find("ohm, rad with the prefixes"), std::string::npos) << message("3 furlong");
  EXPECT_NE(message("6,35 mm").find("has a comma in its number"), std::string::npos) << message("6,35 mm");
}

TEST(Units, NamesAndExamples)
{
  EXPECT_EQ(dimension_name(dimension::pressure), "pressure");
  EXPECT_EQ(si_unit(dimension::pressure), "Pa");
  EXPECT_EQ(si_unit(dimension::conductance), "W/(m^2 K)");
  EXPECT_EQ(si_unit({.mass = 1, .time = -3, .temperature = -2}), "kg s^-3 K^-2"); // no unit has a name for it
  for (const Dimension d : {dimension::length, dimension::pressure, dimension::conductivity, dimension::density,
                            dimension::specific_heat, dimension::expansion})
    EXPECT_EQ(quantity(example_quantity(d)).dimension, d);
}

} // namespace

} // namespace brinell::io::units_test
