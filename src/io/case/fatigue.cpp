// SPDX-License-Identifier: BSD-3-Clause
#include "fatigue.hpp"

#include "schema_parts.hpp"

/// Keys and reading of the fatigue of a material.
namespace brinell::io
{

namespace
{

using constitutive::Fatigue;

/// Words of the criteria, in the order of `Fatigue::Criterion`.
const std::vector<std::string>& criteria()
{
  static const std::vector<std::string> words{"none", "dang_van", "crossland", "findley", "fatemi_socie"};
  return words;
}

} // namespace

std::vector<Entry> fatigue_entries(const std::string& material)
{
  const std::string table = material + "fatigue.", criterion = table + "criterion";
  const Condition judged{criterion, {criteria().begin() + 1, criteria().end()}}, followed{criterion, criteria()};
  const Fatigue usual;
  constexpr double most_exponent = 30.0;
  return joined(
      {in_table(
           table, {material + "rigid", {"false"}},
           {
               {.key = "criterion",
                .choices = criteria(),
                .unset = "no fatigue",
                .text = "Criterion by which the stress history of each point of the body over the last cycle (pass, "
                        "stroke, cycle, indent) is judged. dang_van: mesoscopic shear and hydrostatic stress (Dang Van "
                        "1989); crossland: amplitude of sqrt(J2) and largest hydrostatic stress (Crossland 1956); "
                        "findley: shear amplitude and largest normal stress on the worst plane (Findley 1959); "
                        "fatemi_socie: shear strain amplitude, with plastic strain, and largest normal stress on "
                        "the worst plane (Fatemi and Socie 1988); none: shear amplitudes, shakedown and life only."},
           }),
       in_table(table, judged,
                {
                    {.key = "torsion_limit",
                     .of = kind::pressure.above(0.0),
                     .required = true,
                     .text = "Amplitude of the shear stress endured in reversed torsion.",
                     .hint = "bearing steel has some 400 to 500 MPa"},
                    {.key = "bending_limit",
                     .of = kind::pressure.above(0.0),
                     .required = true,
                     .text = "Amplitude of the stress endured in reversed bending. Its ratio to the torsion limit sets "
                             "the weight of the hydrostatic or normal stress.",
                     .hint = "about 1.3 to 1.9 times the torsion limit"},
                }),
       in_table(table, {criterion, {"findley", "fatemi_socie"}},
                {
                    {.key = "map",
                     .choices = {"worst", "all"},
                     .fallback = "worst",
                     .text = "Cells in which a criterion of critical planes is evaluated: those of the track that may "
                             "reach 0.9 of its largest value (others have no value, NaN), or all, which takes far "
                             "longer."},
                }),
       in_table(table, followed,
                {
                    {.key = "stress_exponent",
                     .of = kind::number.up_to(0.0, most_exponent),
                     .fallback = usual.stress_exponent,
                     .text = "Exponent c of the shear amplitude in the stress-volume integral of Lundberg and Palmgren "
                             "(1947)."},
                    {.key = "weibull_slope",
                     .of = kind::number.up_to(0.0, most_exponent),
                     .fallback = usual.weibull_slope,
                     .text = "Exponent e of the life: 10/9 for point contact, 9/8 for line contact."},
                    {.key = "depth_exponent",
                     .of = kind::number.between(0.0, most_exponent),
                     .fallback = usual.depth_exponent,
                     .text = "Exponent h of the depth, by which the integrand is divided."},
                    {.key = "shear_threshold",
                     .of = kind::pressure.at_least(0.0),
                     .fallback = usual.threshold,
                     .text = "Shear amplitude that causes no failure; it is subtracted in the integral (Ioannides and "
                             "Harris 1985)."},
                    {.key = "reference",
                     .of = kind::number.above(0.0),
                     .unset = "median over the columns of the track",
                     .text = "Stress-volume per length of track, stress_volume of the summary, of the case whose "
                             "life is 1."},
                })});
}

std::optional<Fatigue> read_fatigue(const CaseReader& reader, const std::string& table)
{
  if (!reader.has(table + "criterion"))
    return std::nullopt;
  const auto& word = reader.get<std::string>(table + "criterion");
  Fatigue fatigue;
  fatigue.criterion = static_cast<Fatigue::Criterion>(std::ranges::find(criteria(), word) - criteria().begin());
  const auto read = [&](const char* key, double& number) { number = reader.get_or(table + key, number); };
  read("torsion_limit", fatigue.torsion_limit);
  read("bending_limit", fatigue.bending_limit);
  read("stress_exponent", fatigue.stress_exponent);
  read("weibull_slope", fatigue.weibull_slope);
  read("depth_exponent", fatigue.depth_exponent);
  read("shear_threshold", fatigue.threshold);
  fatigue.whole_map = reader.get_or<std::string>(table + "map", "worst") == "all";
  if (reader.has(table + "reference"))
    fatigue.reference = reader.get<double>(table + "reference");
  const bool has_limits = reader.has(table + "torsion_limit") && reader.has(table + "bending_limit");
  if (const std::string reason = has_limits ? reason_against(fatigue) : std::string(); !reason.empty())
    reader.problems.add(
        reader.place(table + "torsion_limit"),
        fmt::format("{0}torsion_limit = {1:.4g} Pa does not fit {0}bending_limit = {2:.4g} Pa and {0}criterion = "
                    "\"{3}\": {4}",
                    table, fatigue.torsion_limit, fatigue.bending_limit, word, reason));
  return fatigue;
}

} // namespace brinell::io
