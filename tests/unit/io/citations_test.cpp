// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/io/citations.hpp"

#include "brinell/io/versions.hpp"
#include "sample.hpp"

#include <regex>
#include <set>

namespace brinell::io::citations_test
{

namespace
{

std::set<std::string> keys(const Case& c)
{
  std::set<std::string> result;
  for (const Citation& citation : citations(c))
    EXPECT_TRUE(result.insert(citation.reference.key).second) << citation.reference.key << " twice";
  return result;
}

const std::string* use_of(const std::vector<Citation>& all, const std::string& key)
{
  for (const Citation& citation : all)
    if (citation.reference.key == key)
      return &citation.use;
  return nullptr;
}

constexpr std::string_view elastic_rolling = R"(scenario = "rolling"
[lower]
shape = {type = "flat"}
material = {young_modulus = "200 GPa", poisson_ratio = 0.3}
[upper]
shape = {type = "sphere", radius = "1 mm"}
material = {young_modulus = "200 GPa", poisson_ratio = 0.3}
[rolling]
load = "10 N"
distance = "0.2 mm"
passes = 2
)";

Case rolling(const std::vector<std::string>& overrides = {})
{
  return parse_case(elastic_rolling, "rolling.toml", overrides);
}

const std::string law = "lower.material.hardening=";

TEST(Citations, OfAPerfectlyPlasticTuggingUnderPaperKinematics)
{
  const Case c = sample::parsed({"tugging.kinematics=paper"});
  const auto all = citations(c);
  EXPECT_EQ(all.front().reference.key, "boucly2006");
  EXPECT_NE(all.front().use.find("Eqs. 9 to 13"), std::string::npos);
  EXPECT_EQ(keys(c),
            (std::set<std::string>{"boucly2006", "love1929", "liu2000", "polonsky1999", "hertz1882", "green2005",
                                   "jacq2002", "chiu1978", "ortiz1985", "anderson1965", "walker2011"}));
}

TEST(Citations, OfExactKinematicsLeaveThePapersOut)
{
  const auto all = citations(sample::parsed());
  EXPECT_EQ(use_of(all, "boucly2006")->find("Eqs."), std::string::npos);
}

TEST(Citations, OfAnElasticCaseHaveNoPlasticity)
{
  EXPECT_EQ(keys(rolling()), (std::set<std::string>{"boucly2006", "love1929", "liu2000", "polonsky1999", "hertz1882"}));
}

TEST(Citations, FollowTheHardeningLaw)
{
  const std::vector<std::pair<std::string, std::string>> laws{
      {R"({law = "swift", coefficient = "2 GPa", offset = 0.002, exponent = 0.1})", "swift1952"},
      {R"({law = "swift_microstrain", coefficient = "945 MPa", offset = 20, exponent = 0.1})", "swift1952"},
      {R"({law = "hollomon", yield_stress = "1 GPa", coefficient = "2 GPa", exponent = 0.1})", "hollomon1945"},
      {R"({law = "ludwik", yield_stress = "1 GPa", coefficient = "2 GPa", exponent = 0.5})", "ludwik1909"},
      {R"({law = "voce", yield_stress = "1 GPa", saturation = "1 GPa", rate = 10})", "voce1948"},
      {R"({law = "linear", yield_stress = "1 GPa", modulus = "1 GPa"})", ""},
  };
  const std::set<std::string> sources{"swift1952", "hollomon1945", "ludwik1909", "voce1948"};
  for (const auto& [text, expected] : laws)
  {
    std::set<std::string> cited = keys(rolling({law + text}));
    std::erase_if(cited, [&](const std::string& key) { return !sources.contains(key); });
    EXPECT_EQ(cited, expected.empty() ? std::set<std::string>{} : std::set<std::string>{expected}) << text;
  }
  const auto microstrain = citations(rolling({law + laws[1].first}));
  EXPECT_NE(use_of(microstrain, "jacq2002")->find("millionths"), std::string::npos);
}

TEST(Citations, FollowTheBackStresses)
{
  const auto with = [](const std::string& kinematic)
  { return keys(rolling({law + R"({law = "perfect", yield_stress = "1 GPa", )" + kinematic + "}"})); };
  const auto prager = with(R"(back_stresses = [{modulus = "10 GPa"}])");
  EXPECT_TRUE(prager.contains("prager1956") && !prager.contains("armstrong1966") && !prager.contains("chaboche1986"));
  const auto armstrong = with(R"(back_stresses = {modulus = "10 GPa", recall = 50})");
  EXPECT_TRUE(!armstrong.contains("prager1956") && armstrong.contains("armstrong1966") &&
              !armstrong.contains("chaboche1986"));
  const auto several = with(R"(back_stresses = [{modulus = "10 GPa", recall = 50}, {modulus = "1 GPa"}])");
  EXPECT_TRUE(several.contains("prager1956") && several.contains("armstrong1966") && several.contains("chaboche1986"));
}

TEST(Citations, FollowSolverTextureAndPasses)
{
  const std::string perfect = law + R"({law = "perfect", yield_stress = "1 GPa"})";
  const auto euler = keys(rolling({perfect, "solver.integration=backward_euler", "solver.anderson_depth=0"}));
  EXPECT_TRUE(euler.contains("wilkins1964") && euler.contains("simo1998") && !euler.contains("ortiz1985"));
  EXPECT_TRUE(!euler.contains("anderson1965") && !euler.contains("walker2011"));
  EXPECT_TRUE(euler.contains("johnson1985")) << "shakedown in two passes";
  EXPECT_FALSE(keys(rolling({perfect, "rolling.passes=1"})).contains("johnson1985"));
  EXPECT_FALSE(keys(rolling()).contains("ville1999"));
  EXPECT_TRUE(keys(rolling({R"(lower.texture={type = "dent", depth = "1 um", edge_radius = "12.5 um"})"}))
                  .contains("ville1999"));
  const auto both =
      keys(rolling({R"(lower.texture=[{type = "dent", depth = "1 um", edge_radius = "12.5 um"}, {type = "random", )"
                    R"(rms_height = 1e-7, rolloff = 1e-4, cutoff = 5e-5}])"}));
  EXPECT_TRUE(both.contains("ville1999") && both.contains("jacobs2017"));
}

/// A field of a source; empty without it.
std::string field(const Reference& reference, const std::string& name)
{
  const auto found = reference.fields.find(name);
  return found == reference.fields.end() ? "" : found->second;
}

TEST(References, AreComplete)
{
  const std::set<std::string> kinds{"article", "book",      "incollection", "inproceedings",
                                    "misc",    "phdthesis", "techreport"};
  std::set<std::string> seen;
  ASSERT_GT(all_references().size(), 20u);
  for (const Reference& r : all_references())
  {
    SCOPED_TRACE(r.key);
    EXPECT_TRUE(seen.insert(r.key).second) << "twice";
    EXPECT_TRUE(kinds.contains(r.kind)) << r.kind;
    EXPECT_TRUE(!field(r, "author").empty() && !field(r, "title").empty());
    EXPECT_TRUE(r.key == "brinell" || r.key.ends_with(field(r, "year"))) << field(r, "year");
    for (const char* needed : {"journal", "volume", "pages"})
      EXPECT_TRUE(r.kind != "article" || !field(r, needed).empty()) << needed;
    EXPECT_TRUE(field(r, "doi").empty() || std::regex_match(field(r, "doi"), std::regex(R"(10\.\d{4,}/\S+)")));
    EXPECT_TRUE(r.bibtex.starts_with("@" + r.kind + "{" + r.key + ",\n") && r.bibtex.ends_with("}\n")) << r.bibtex;
  }
}

TEST(References, AreReadFromBibtex)
{
  const std::string love = "@article{love1929,\n  author = {Love, A. E. H. and Else, S.},\n  title = {{The stress}},\n"
                           "  journal = {Phil. Trans.},\n  volume = {228},\n  pages = {377--420},\n  year = {1929},\n"
                           "  doi = {10.1098/rsta.1929.0009},\n}\n";
  const std::string report = "@techreport{a1,\n  author = {A},\n  title = {{B}},\n  institution = {C},\n"
                             "  number = {D},\n  note = {E},\n}\n";
  const auto read = read_bibtex("% of two\n\n" + love + "\n" + report);
  ASSERT_EQ(read.size(), 2u);
  EXPECT_EQ(read[0].bibtex, love);
  EXPECT_EQ(read[1].bibtex, report);
  EXPECT_EQ(reference_text(read[0]), "Love, A. E. H., Else, S. (1929). The stress. Phil. Trans. 228, 377-420. "
                                     "https://doi.org/10.1098/rsta.1929.0009");
  EXPECT_EQ(reference_text(read[1]), "A. B. C, Report D. E.");
}

// The program cannot read the file where it is installed.
TEST(References, BrinellIsThatOfTheCitationFile)
{
  const std::string file = sample::file_text(BRINELL_SOURCE_DIR "/CITATION.cff");
  const Reference& brinell = brinell_reference();
  EXPECT_NE(file.find("title: \"" + field(brinell, "title") + "\""), std::string::npos);
  EXPECT_NE(file.find("name: \"" + field(brinell, "author") + "\""), std::string::npos);
}

TEST(References, HaveTheVersionOfTheProgram)
{
  EXPECT_EQ(field(brinell_reference(), "note"), "Version " + library_versions().brinell);
}

TEST(References, LinesBeginWithTheProgram)
{
  const Case c = sample::parsed();
  const auto lines = citation_lines(c);
  ASSERT_EQ(lines.size(), citations(c).size() + 1);
  EXPECT_TRUE(lines.front().starts_with("The brinell authors (2026). brinell: ")) << lines.front();
  EXPECT_TRUE(lines[1].ends_with("[tugging of two asperities, their motion and forces]")) << lines[1];
}

} // namespace

} // namespace brinell::io::citations_test
