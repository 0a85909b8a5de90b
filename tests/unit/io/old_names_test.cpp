// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/foundation/error.hpp"
#include "brinell/io/schema.hpp"
#include "sample.hpp"

namespace brinell::io::old_names_test
{

namespace
{

using sample::parsed;

const std::string hardening = "lower.material.hardening.";
const std::string perfect = "lower.material.hardening={law=\"perfect\", yield_stress=\"900 MPa\", ";

std::vector<constitutive::KinematicTerm> terms(const Case& c)
{
  return sample::tugging(c).lower.material.kinematic;
}

/// The warnings of a case on its old names.
std::vector<std::string> told(const Case& c)
{
  std::vector<std::string> texts;
  for (const Warning& warning : c.warnings)
    if (warning.key == "old_name")
      texts.push_back(warning.text);
  return texts;
}

std::string refusal(const std::vector<std::string>& overrides, const std::string& more = "")
{
  try
  {
    static_cast<void>(parse_case(std::string(sample::case_text) + more, "sample.toml", overrides));
  }
  catch (const InputError& error)
  {
    return error.what();
  }
  return "";
}

TEST(OldNames, EachLeadsToAKeyAndIsNone)
{
  for (const OldName& name : old_names())
  {
    const auto list = name.key.find("[]");
    const std::string key =
        list == name.key.npos ? std::string(name.key) : std::string(name.key).replace(list, 2, "[0]");
    EXPECT_NE(find_entry(key), nullptr) << key;
    EXPECT_EQ(find_entry(name.old_key), nullptr) << name.old_key;
    EXPECT_LT(name.key, name.old_key) << "that both are given would not be told";
    EXPECT_EQ(schema_markdown().find(name.old_key.substr(name.old_key.rfind('.') + 1)), std::string::npos);
    EXPECT_EQ(schema_json().find(name.old_key.substr(name.old_key.rfind('.') + 1)), std::string::npos);
    EXPECT_THROW(static_cast<void>(schema_text(name.old_key)), InputError);
  }
}

TEST(OldNames, GoOnWorkingWithAWarning)
{
  const Case of_file = parse_case(std::string(sample::case_text) + "[solver]\nmax_iterations = 7\n", "sample.toml");
  EXPECT_EQ(sample::tugging(of_file).solver.max_evaluations, 7);
  ASSERT_EQ(told(of_file).size(), 1u);
  EXPECT_NE(told(of_file).front().find("solver.max_iterations is now called solver.max_evaluations"), std::string::npos)
      << told(of_file).front();
  const Case of_override = parsed({"solver.max_iterations=8"});
  EXPECT_EQ(sample::tugging(of_override).solver.max_evaluations, 8);
  EXPECT_EQ(told(of_override).size(), 1u);
  EXPECT_TRUE(told(parsed({"solver.max_evaluations=8"})).empty());
  EXPECT_EQ(resolved_text(of_override.values).find("max_iterations"), std::string::npos);
}

TEST(OldNames, TheCommandLineWinsOverTheFileByEitherName)
{
  const auto evaluations = [](const char* of_file, const char* of_override)
  {
    const Case c = parse_case(std::string(sample::case_text) + of_file, "sample.toml", {of_override});
    return sample::tugging(c).solver.max_evaluations;
  };
  EXPECT_EQ(evaluations("[solver]\nmax_iterations = 7\n", "solver.max_evaluations=8"), 8);
  EXPECT_EQ(evaluations("[solver]\nmax_evaluations = 7\n", "solver.max_iterations=8"), 8);
  EXPECT_EQ(evaluations("[solver]\nmax_evaluations = 7\n", "solver={max_iterations=8}"), 8);
}

TEST(OldNames, BothNamesOfOneKeyAreAnError)
{
  const std::string both = "solver.max_iterations is an old name of solver.max_evaluations, which is given, too";
  EXPECT_EQ(refusal({}, "[solver]\nmax_evaluations = 7\nmax_iterations = 7\n").find("sample.toml:15: " + both), 0u)
      << refusal({}, "[solver]\nmax_evaluations = 7\nmax_iterations = 7\n");
  EXPECT_NE(refusal({"solver={max_evaluations=7, max_iterations=7}"}).find(both), std::string::npos);
  const std::string lists = refusal({perfect + "back_stresses=[{modulus=1e9}], kinematic_moduli=[1e9]}"});
  EXPECT_NE(lists.find("kinematic_moduli is an old name of lower.material.hardening.back_stresses"), std::string::npos)
      << lists;
}

TEST(OldNames, ListsOfModuliAndRecallBecomeBackStresses)
{
  const std::vector<constitutive::KinematicTerm> two{{90e9, 600.0}, {1e9, 0.0}}, prager{{20e9, 0.0}};
  const Case c = parsed({perfect + "kinematic_moduli=[\"90 GPa\", 1e9], kinematic_recall=[600, 0]}"});
  EXPECT_EQ(terms(c), two);
  EXPECT_EQ(told(c).size(), 2u);
  EXPECT_EQ(terms(parse_case(resolved_text(c.values), "resolved.toml")), two);
  EXPECT_EQ(terms(parsed({perfect + "kinematic_moduli=[\"20 GPa\"]}"})), prager);
  const std::string file = perfect + "kinematic_moduli=[90e9, 1e9], kinematic_recall=[600, 50]}";
  EXPECT_EQ(terms(parsed({file, hardening + "kinematic_recall=[600, 0]"})), two);
  EXPECT_EQ(terms(parsed({file, hardening + "back_stresses=[{modulus=20e9}]"})), prager);
  const std::string anew = perfect + "back_stresses=[{modulus=90e9, recall=600}, {modulus=1e9}]}";
  EXPECT_EQ(terms(parsed({anew, hardening + "kinematic_moduli=[20e9]"})), prager);
}

TEST(OldNames, ListsThatDoNotFitAreRefused)
{
  const auto refused = [](const std::string& keys) { return refusal({perfect + keys + "}"}); };
  for (const auto& [keys, text] : std::vector<std::pair<std::string, std::string>>{
           {"kinematic_moduli=[1e9], kinematic_recall=[600, 0]", "kinematic_moduli has 1 of 2 entries"},
           {"kinematic_moduli=[1e9, 1e9], kinematic_recall=[600]", "kinematic_recall has 1 of 2 entries"},
           {"kinematic_recall=[600]", "back_stresses[0].modulus is missing"},
           {"kinematic_moduli=1e9", "kinematic_moduli = 1000000000.0 is a number; allowed: a list"},
           {"kinematic_moduli=[]", "is empty"},
           {"kinematic_moduli=[\"1 mm\"]", "back_stresses[0].modulus = \"1 mm\" is a length"}})
    EXPECT_NE(refused(keys).find(text), std::string::npos) << refused(keys);
  EXPECT_NE(refusal({hardening + "law=none", hardening + "kinematic_moduli=[1e9]"}).find("applies only with"),
            std::string::npos);
}

} // namespace

} // namespace brinell::io::old_names_test
