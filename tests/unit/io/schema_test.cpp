// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/io/schema.hpp"

#include "brinell/foundation/error.hpp"
#include "io/case/suggestion.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

namespace brinell::io::schema_test
{

namespace
{

TEST(Schema, IsConsistent)
{
  std::set<std::string> seen;
  for (const Entry& entry : case_schema())
  {
    SCOPED_TRACE(entry.key);
    EXPECT_TRUE(seen.insert(entry.key).second) << "declared twice";
    EXPECT_FALSE(is_table(entry.key)) << "a key cannot be a table as well";
    EXPECT_FALSE(entry.text.empty());
    // Exactly one answer to the question what happens if the key is left out; an exclusive pair may have both.
    EXPECT_TRUE(entry.required || entry.fallback || !entry.unset.empty());
    EXPECT_FALSE(entry.required && entry.fallback);
    EXPECT_EQ(entry.of.type == Type::choice || entry.of.type == Type::words, !entry.choices.empty());
    for (const std::string& other : {entry.when.key, entry.pure_if})
      EXPECT_TRUE(other.empty() || seen.contains(other)) << "depends on " << other << ", which must come before";
    if (!entry.excludes.empty())
    {
      ASSERT_NE(find_entry(entry.excludes), nullptr);
      EXPECT_EQ(find_entry(entry.excludes)->excludes, entry.key) << "exclusion is mutual";
    }
  }
}

TEST(Schema, DefaultsAreInRange)
{
  for (const Entry& entry : case_schema())
  {
    if (!entry.fallback)
      continue;
    double value = 0.0;
    if (const auto* x = std::get_if<double>(&*entry.fallback))
      value = *x;
    else if (const auto* i = std::get_if<std::int64_t>(&*entry.fallback))
      value = static_cast<double>(*i);
    else
      continue;
    EXPECT_TRUE(entry.of.range.contains(value)) << entry.key;
  }
}

TEST(Schema, RangesKnowTheirEnds)
{
  const Range poisson{.min = -1.0, .max = 0.5, .min_allowed = false, .max_allowed = false};
  EXPECT_FALSE(poisson.contains(0.5));
  EXPECT_FALSE(poisson.contains(-1.0));
  EXPECT_TRUE(poisson.contains(0.4999));
  EXPECT_EQ(poisson.text(), "in (-1, 0.5)");
  EXPECT_FALSE(Range{}.contains(std::nan("")));
  EXPECT_FALSE(Range{}.contains(INFINITY));
  EXPECT_EQ((Range{.min = 0.0, .min_allowed = false}.text()), "> 0");
}

TEST(Schema, PrintsEveryKey)
{
  const std::string text = schema_text(), page = schema_markdown();
  for (const Entry& entry : case_schema())
  {
    EXPECT_NE(text.find(entry.key + "\n"), text.npos) << entry.key;
    const auto tail = entry.key.substr(entry.key.find('.') + 1);
    EXPECT_NE(page.find("| `" + tail + "` |"), page.npos) << entry.key;
  }
}

TEST(Schema, TellsOneKeyOrTheKeysOfATable)
{
  EXPECT_EQ(schema_text("grid.resolution").rfind("grid.resolution\n", 0), 0u);
  EXPECT_EQ(schema_text("grid.resolution").find("grid.spacing\n"), std::string::npos);
  const std::string grid = schema_text("grid");
  for (const char* key : {"grid.spacing\n", "grid.resolution\n", "grid.extent\n"})
    EXPECT_NE(grid.find(key), grid.npos) << key;
  EXPECT_EQ(grid.find("solver."), grid.npos);
  EXPECT_THROW((void)schema_text("gri"), InputError);
}

TEST(Schema, OfEditorsHasEveryKey)
{
  const auto schema = nlohmann::json::parse(schema_json());
  for (const Entry& entry : case_schema())
  {
    SCOPED_TRACE(entry.key);
    const nlohmann::json* at = &schema;
    std::istringstream parts(entry.key);
    for (std::string part; std::getline(parts, part, '.');)
    {
      ASSERT_FALSE(at->at("additionalProperties").get<bool>());
      ASSERT_TRUE(at->at("properties").contains(part));
      at = &at->at("properties").at(part);
      if (at->contains("anyOf") && at->at("anyOf").at(0).contains("properties")) // one table, or a list of them
      {
        EXPECT_EQ(at->at("anyOf").at(1).at("items"), at->at("anyOf").at(0));
        at = &at->at("anyOf").at(0);
      }
    }
    EXPECT_NE(at->at("description").get<std::string>().find(entry.text), std::string::npos);
    if (entry.of.type == Type::words) // one of the choices, or a list of them
    {
      EXPECT_EQ(at->at("anyOf").at(1).at("items"), at->at("anyOf").at(0));
      at = &at->at("anyOf").at(0);
    }
    const auto choices = at->value("enum", std::vector<std::string>{});
    EXPECT_EQ(choices, entry.choices);
  }
  const auto& poisson = schema["properties"]["lower"]["properties"]["material"]["properties"]["poisson_ratio"];
  EXPECT_EQ(poisson["exclusiveMaximum"], 0.5);
  EXPECT_EQ(schema["properties"]["grid"]["properties"]["spacing"]["minItems"], 3);
}

TEST(Suggestion, CountsEdits)
{
  EXPECT_EQ(edit_distance("radius", "radius"), 0);
  EXPECT_EQ(edit_distance("raduis", "radius"), 1); // two neighbours swapped
  EXPECT_EQ(edit_distance("", "abc"), 3);
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3);
}

TEST(Suggestion, FindsWhatWasMeant)
{
  EXPECT_EQ(suggestion("lower.shape.raduis"), "did you mean lower.shape.radius?");
  EXPECT_EQ(suggestion("lower.material.E"), "did you mean lower.material.young_modulus?");
  EXPECT_EQ(suggestion("upper.material.nu"), "did you mean upper.material.poisson_ratio?");
  EXPECT_EQ(suggestion("indentation.P"), "did you mean indentation.load?");
  EXPECT_EQ(suggestion("upper.material.poisson"), "did you mean upper.material.poisson_ratio?");
  EXPECT_EQ(suggestion("upper.young_modulus"), "did you mean upper.material.young_modulus?");
  EXPECT_EQ(suggestion("kinematics"), "did you mean tugging.kinematics?");
  EXPECT_EQ(suggestion("indentation.force"), "did you mean indentation.load?");
  EXPECT_EQ(suggestion("load", "rolling"), "did you mean rolling.load?");
  EXPECT_EQ(suggestion("lower.young_modulus", "rolling"), "did you mean lower.material.young_modulus?");
  EXPECT_EQ(suggestion("grid.colour"),
            "allowed in grid: boundary, size, cells, layer, reference, spacing, resolution, extent");
}

} // namespace

} // namespace brinell::io::schema_test
