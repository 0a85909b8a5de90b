// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/foundation/error.hpp"
#include "brinell/io/case_file.hpp"
#include "sample.hpp"

#include <gtest/gtest.h>

#include <fstream>

/// Hardening laws as they stand in a case file.
namespace brinell::io::hardening_case_test
{
namespace
{

using constitutive::HardeningLaw;

std::string law(const std::string& keys)
{
  return "lower.material.hardening={law=" + keys + "}";
}

HardeningLaw read(const std::string& keys)
{
  return sample::tugging(sample::parsed({law(keys)})).lower.material.hardening.value();
}

std::string message(const std::string& keys)
{
  try
  {
    (void)sample::parsed({law(keys)});
  }
  catch (const InputError& error)
  {
    return error.what();
  }
  return "no error";
}

void expect_message(const std::string& keys, const std::vector<std::string>& parts)
{
  const std::string text = message(keys);
  for (const std::string& part : parts)
    EXPECT_NE(text.find(part), std::string::npos) << part << " is not in: " << text;
}

TEST(HardeningCase, EveryLawIsBuilt)
{
  using namespace constitutive;
  EXPECT_EQ(read(R"("perfect", yield_stress="900 MPa")"), HardeningLaw(PerfectPlasticity{900e6}));
  EXPECT_EQ(read(R"("linear", yield_stress="900 MPa", modulus="2 GPa")"), HardeningLaw(LinearHardening{900e6, 2e9}));
  EXPECT_EQ(read(R"("swift", coefficient="1.5 GPa", offset=0.002, exponent=0.1)"),
            HardeningLaw(SwiftHardening{1.5e9, 0.002, 0.1}));
  EXPECT_EQ(read(R"("swift_microstrain", coefficient="900 MPa", offset=20, exponent=0.08)"),
            HardeningLaw(swift_of_microstrain(900e6, 20.0, 0.08)));
  EXPECT_EQ(read(R"("hollomon", yield_stress="900 MPa", coefficient="1.5 GPa", exponent=0.1)"),
            HardeningLaw(hollomon(900e6, 1.5e9, 0.1)));
  EXPECT_EQ(read(R"("ludwik", yield_stress="900 MPa", coefficient="1.5 GPa", exponent=0.5)"),
            HardeningLaw(LudwikHardening{900e6, 1.5e9, 0.5}));
  EXPECT_EQ(read(R"("voce", yield_stress="900 MPa", saturation="300 MPa", rate=25)"),
            HardeningLaw(VoceHardening{900e6, 300e6, 25.0}));
  EXPECT_EQ(read(R"("table", plastic_strain=[0, 0.01, 0.1], stress=["900 MPa", "1.1 GPa", 1.2e9])"),
            HardeningLaw(TabulatedHardening({0.0, 0.01, 0.1}, {900e6, 1.1e9, 1.2e9})));
}

TEST(HardeningCase, BackStressesStandBesideAnyLaw)
{
  const auto terms = [](const std::string& keys)
  { return sample::tugging(sample::parsed({law(keys)})).lower.material.kinematic; };
  EXPECT_TRUE(terms(R"("perfect", yield_stress="900 MPa")").empty());
  EXPECT_EQ(
      terms(R"("perfect", yield_stress="900 MPa", back_stresses=[{modulus="90 GPa", recall=600}, {modulus=1e9}])"),
      (std::vector<constitutive::KinematicTerm>{{90e9, 600.0}, {1e9, 0.0}}));
  EXPECT_EQ(terms(R"("voce", yield_stress="900 MPa", saturation=1e8, rate=3, back_stresses={modulus="20 GPa"})"),
            (std::vector<constitutive::KinematicTerm>{{20e9, 0.0}}));
  expect_message(R"("perfect", yield_stress="900 MPa", back_stresses=[{modulus=1e9}, {recall=600}])",
                 {"back_stresses[1].modulus is missing; allowed: pressure >= 0"});
  expect_message(R"("perfect", yield_stress="900 MPa", back_stresses={recall=600})",
                 {"back_stresses.modulus is missing"});
  expect_message(R"("perfect", yield_stress="900 MPa", back_stresses=[{modulus="1 mm"}])",
                 {"back_stresses[0].modulus = \"1 mm\" is a length"});
  expect_message(R"("none", back_stresses=[{modulus=1e9}])", {"back_stresses[0].modulus", "applies only with"});
}

TEST(HardeningCase, ProfilesOverDepthAreReadAndChecked)
{
  const auto material = [](const std::vector<std::string>& keys)
  {
    std::vector<std::string> all;
    for (const std::string& key : keys)
      all.push_back("lower.material." + key);
    return sample::tugging(sample::parsed(all)).lower.material;
  };
  const auto m = material({"yield_profile={depth=[0, \"2 mm\", 0.01], factor=[1.5, 1.2, 1]}",
                           "initial_stress={depth=[0, \"4 mm\"], value=[\"-600 MPa\", 0]}"});
  EXPECT_DOUBLE_EQ(m.yield_factor.at(0.001, 1.0), 1.35);
  EXPECT_DOUBLE_EQ(m.yield_factor.at(1.0, 1.0), 1.0);
  EXPECT_DOUBLE_EQ(m.initial_stress.at(0.002, 0.0), -300e6);
  EXPECT_TRUE(material({}).yield_factor.empty());
  for (const char* bad : {"yield_profile={depth=[0, 1], factor=[1]}", "yield_profile={depth=[1, 0], factor=[1, 1]}",
                          "yield_profile={factor=[2]}", "yield_profile={depth=[0], factor=[0]}",
                          "initial_stress={depth=[0], value=[\"-1 GPa\"]}"}) // beyond the yield stress
    EXPECT_THROW((void)material({bad}), InputError) << bad;
}

TEST(HardeningCase, CriticalValuesAreThoseOfTheVirginYieldStress)
{
  const auto critical = [](const std::string& keys) { return sample::parsed({law(keys)}).first_yield->critical; };
  EXPECT_EQ(critical(R"("voce", yield_stress="900 MPa", saturation="300 MPa", rate=25)").interference,
            critical(R"("perfect", yield_stress="900 MPa")").interference);
}

TEST(HardeningCase, BadLawsNameTheKeyAndWhatIsAllowed)
{
  expect_message(R"("swfit", coefficient=1)", {"\"swfit\" is not known", "\"swift\"", "\"table\""});
  expect_message(R"("swift", coefficient="1 GPa", offset=0, exponent=0.1)", {"hardening.offset = 0", "> 0"});
  expect_message(R"("swift", coefficient="1 GPa", offset=0.01)", {"hardening.exponent is missing"});
  expect_message(R"("ludwik", yield_stress="1 GPa", coefficient="1 GPa", exponent=1.5)", {"exponent = 1.5", "(0, 1]"});
  expect_message(R"("voce", yield_stress="1 GPa", saturation="1 GPa", rate=3, modulus="1 GPa")",
                 {"hardening.modulus", "applies only with", "\"linear\""});
  expect_message(R"("table")", {"needs lower.material.hardening.plastic_strain", "file"});
  expect_message(R"("table", plastic_strain=[0, 0.1], stress=["1 GPa"])", {"2 strains and 1 stresses"});
  expect_message(R"("table", plastic_strain=[0, 0.1], stress=["1 GPa", "0.9 GPa"])", {"must not fall", "softening"});
  expect_message(R"("table", plastic_strain=[0, 0.1], stress=["1 GPa", "2 mm"])", {"element \"2 mm\"", "length"});
  expect_message(R"("table", plastic_strain=[], stress=[])", {"has 0 elements"});
}

class HardeningFile : public testing::Test
{
protected:
  sample::TemporaryFolder folder;

  void write(const std::string& text) const { std::ofstream(folder.path() / "curve.csv") << text; }
  [[nodiscard]] Case parsed(const std::string& keys = R"("table", file="curve.csv")") const
  {
    return parse_case(sample::case_text, folder.path() / "case.toml", {law(keys)});
  }
  [[nodiscard]] std::string message() const
  {
    try
    {
      (void)parsed();
    }
    catch (const InputError& error)
    {
      return error.what();
    }
    return "no error";
  }
};

TEST_F(HardeningFile, IsReadFromTheFolderOfTheCaseAndResolvedIntoIt)
{
  write("plastic strain, stress in Pa\n# measured\n0, 900e6\n0.01; 1.1e9\n\n0.1\t1200000000\n");
  const Case c = parsed();
  const HardeningLaw expected = constitutive::TabulatedHardening({0.0, 0.01, 0.1}, {900e6, 1.1e9, 1.2e9});
  EXPECT_EQ(sample::tugging(c).lower.material.hardening.value(), expected);
  const Case again = parse_case(resolved_text(c.values), "/elsewhere/resolved.toml");
  EXPECT_EQ(sample::tugging(again).lower.material.hardening.value(), expected);
}

TEST_F(HardeningFile, UnitsCommasAndTitlesAreThoseOfTheFile)
{
  const HardeningLaw expected = constitutive::TabulatedHardening({0.0, 0.002, 0.01}, {930e6, 1010.5e6, 1.2e9});
  const std::string keys = R"("table", file="curve.csv", strain_unit="%", stress_unit="MPa")";
  for (const char* text :
       {"0, 930\n0.2, 1010.5\n1, 1200\n",
        "\xef\xbb\xbf"
        "0;930;\r\n0,2;1010,5;\r\n1;1,2e3;\r\n",
        "\"strain\";\"stress\"\n%;MPa\n0;930\n+0,2 ; 1010,5\n1,0;1200,0\n", "0 930\n0,2 1010,5\n1 1200\n",
        "e\ts\n0\t930\n0,2\t1010,5\n1\t1200\n", "0,\t930\n0.2,\t1010.5\n1,\t1200\n"})
  {
    write(text);
    const Case c = parsed(keys);
    EXPECT_EQ(sample::tugging(c).lower.material.hardening.value(), expected) << text; // to the last digit
    EXPECT_EQ(resolved_text(c.values).find("_unit"), std::string::npos) << "what is resolved is in SI";
    EXPECT_EQ(parse_case(resolved_text(c.values), "again.toml").values.all(), c.values.all());
  }
}

TEST_F(HardeningFile, ExamplesAreInTheUnitsOfTheFile)
{
  write("0;930\n0,2;nan\n");
  try
  {
    (void)parsed(R"("table", file="curve.csv", strain_unit="%", stress_unit="MPa")");
    FAIL() << "a stress that is no number";
  }
  catch (const InputError& error)
  {
    EXPECT_NE(std::string(error.what())
                  .find("where nan is not a number; allowed: plastic strain in % and stress in MPa, as in \"0.2, 930\" "
                        "or, with decimal commas, \"0,2; 930\""),
              std::string::npos)
        << error.what();
  }
}

TEST_F(HardeningFile, ScatterIsLiftedIfAsked)
{
  write("0, 2e9\n0.01, 2.7434e9\n0.02, 2.7394e9\n0.03, 2.76e9\n");
  EXPECT_NE(message().find("point 3, 2.7394e+09 Pa, follows"), std::string::npos) << message();
  EXPECT_NE(message().find("monotone = true"), std::string::npos) << message();
  const HardeningLaw expected =
      constitutive::TabulatedHardening({0.0, 0.01, 0.02, 0.03}, {2e9, 2.7434e9, 2.7434e9, 2.76e9});
  EXPECT_EQ(sample::tugging(parsed(R"("table", file="curve.csv", monotone=true)")).lower.material.hardening.value(),
            expected);
  const std::string points = R"("table", monotone=true, plastic_strain=[0, 0.1], stress=["1 GPa", "0.9 GPa"])";
  EXPECT_EQ(read(points), HardeningLaw(constitutive::TabulatedHardening({0.0, 0.1}, {1e9, 1e9})));
}

TEST_F(HardeningFile, UnitsThatAreNoneAreRefused)
{
  write("0, 930\n");
  EXPECT_THROW((void)parsed(R"("table", file="curve.csv", stress_unit="mm")"), InputError);
  EXPECT_THROW((void)parsed(R"("table", file="curve.csv", stress_unit="Mpa")"), InputError);
  EXPECT_THROW((void)parsed(R"("table", file="curve.csv", strain_unit="percent")"), InputError);
  expect_message(R"("table", stress_unit="MPa", plastic_strain=[0], stress=[1e9])", {"is the unit of a file"});
}

TEST_F(HardeningFile, UnitsThatWereForgottenAreWarnedOf)
{
  write("0, 930\n2, 1200\n");
  const Case c = parse_case(sample::case_text, folder.path() / "case.toml",
                            {law(R"("table", file="curve.csv")"), "tugging.interference=0.001", "grid.resolution=8"});
  ASSERT_EQ(c.warnings.size(), 2u);
  EXPECT_EQ(c.warnings[0].key, "low_yield");
  EXPECT_NE(c.warnings[0].text.find("\"930 MPa\""), std::string::npos) << c.warnings[0].text;
  EXPECT_EQ(c.warnings[1].key, "large_table_strain");
}

TEST_F(HardeningFile, ErrorsNameFileLineAndContent)
{
  EXPECT_NE(message().find("cannot be opened"), std::string::npos) << message();
  write("# measured\nstrain, stress\n0, 900e6\n0.01, 1e9\n"); // titles may follow a comment
  EXPECT_EQ(message(), "no error");
  write("strain, stress\n-, Pa\n0, 900e6\n"); // and take several lines
  EXPECT_EQ(message(), "no error");
  write("0, 900e6\nstrain, stress\n");
  EXPECT_NE(message().find("line 2 \"strain, stress\""), std::string::npos) << message();
  write("0,002,930,5\n");
  EXPECT_NE(message().find("line 1 \"0,002,930,5\""), std::string::npos) << message();
  write("0, 900e6\n0.01, many\n");
  EXPECT_NE(message().find("line 2 \"0.01, many\", where many is not a number"), std::string::npos) << message();
  write("0.1, 900e6\n");
  EXPECT_NE(message().find("must begin at plastic strain 0"), std::string::npos) << message();
  write("");
  EXPECT_NE(message().find("curve.csv\" has no line of numbers"), std::string::npos) << message();
  write("0, 900e6\n0.02, 1e9\n0.01, 1.1e9\n0.03, 1e9\n");
  EXPECT_NE(message().find("must ascend"), std::string::npos) << message();
  EXPECT_EQ(message().find("monotone"), std::string::npos)
      << "strains out of order are not mended by it: " << message();
  write("0, 900e6\n");
  EXPECT_THROW((void)parsed(R"("table", file="curve.csv", stress=[1e9])"), InputError);
}

} // namespace
} // namespace brinell::io::hardening_case_test
