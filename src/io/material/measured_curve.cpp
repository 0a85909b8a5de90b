// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/io/measured_curve.hpp"

#include "brinell/foundation/error.hpp"
#include "curve_fit.hpp"
#include "loading.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numeric>

namespace brinell::io
{

namespace
{

using Rules = CurveRules;

/// Stress where the plastic strain first reaches a value, linear between the points, of which the first may be the origin.
struct Crossing
{
  double stress, before, after; ///< [Pa]
  std::size_t point;            ///< the first one at or beyond the strain
};

std::optional<Crossing> crossing(const std::vector<double>& plastic, const std::vector<double>& stress, double strain)
{
  const auto beyond = std::find_if(plastic.begin(), plastic.end(), [&](double e) { return e >= strain; });
  if (beyond == plastic.end())
    return std::nullopt;
  const auto i = static_cast<std::size_t>(beyond - plastic.begin());
  const double e0 = i > 0 ? plastic[i - 1] : 0.0, s0 = i > 0 ? stress[i - 1] : 0.0;
  const double share = *beyond > e0 ? (strain - e0) / (*beyond - e0) : 1.0;
  return Crossing{s0 + share * (stress[i] - s0), s0, stress[i], i};
}

std::vector<double> plastic_strain(const Curve& curve, double slope, double zero)
{
  std::vector<double> result(curve.strain.size());
  for (std::size_t i = 0; i < result.size(); ++i)
    result[i] = curve.strain[i] - zero - curve.stress[i] / slope;
  return result;
}

/// The straight line through the elastic part of the loading, from a tenth to two fifths of the yield stress; none with less than
/// three points there.
std::optional<FittedLine> elastic_line(const Curve& curve, double offset)
{
  constexpr double first = 0.1, last = 0.4;
  double yield = *std::max_element(curve.stress.begin(), curve.stress.end());
  std::optional<FittedLine> line;
  for (int repetition = 0; repetition < 5; ++repetition) // the yield stress depends on the slope, weakly
  {
    std::vector<double> strain, stress;
    for (std::size_t i = 0; i < curve.strain.size() && curve.stress[i] <= yield; ++i)
      if (curve.stress[i] >= first * yield && curve.stress[i] <= last * yield)
      {
        strain.push_back(curve.strain[i]);
        stress.push_back(curve.stress[i]);
      }
    line = strain.size() < 3 ? std::nullopt : fitted_line(strain, stress);
    if (!line || !(line->slope > 0.0))
      return std::nullopt;
    const auto at = crossing(plastic_strain(curve, line->slope, -line->intercept / line->slope), curve.stress, offset);
    if (!at)
      break;
    yield = at->stress;
  }
  return line;
}

/// Warns of an elastic part that does not belong to Young's modulus.
void compare_with_modulus(const FittedLine& line, double young_modulus, double offset, HardeningCurve& result)
{
  constexpr double different = 0.1, large_part = 0.25;
  const double difference = line.slope / young_modulus - 1.0, zero = -line.intercept / line.slope;
  if (std::abs(difference) <= different && std::abs(zero) <= large_part * offset)
    return;
  const std::string what =
      std::abs(difference) > different
          ? fmt::format("the slope of its elastic part, {:.4g} Pa, is {:.0f} % {} Young's modulus, {:.4g} Pa, so that "
                        "the plastic strains are wrong",
                        line.slope, 100.0 * std::abs(difference), difference < 0.0 ? "below" : "above", young_modulus)
          : fmt::format("its elastic part begins at a strain of {:.4g} instead of 0", zero);
  result.warnings.push_back(
      {"curve_slope", what + "; elastic_slope = \"curve\" uses the line of the curve, which takes off the compliance "
                             "of the machine and the strain at its beginning"});
}

double needed_modulus(const Rules& rules)
{
  if (!rules.young_modulus)
    throw InputError("has elastic strains, which need young_modulus; allowed: Young's modulus, or elastic_slope = "
                     "\"curve\" for the slope of the curve itself");
  return *rules.young_modulus;
}

/// The loading with true stress and true total strain. A plastic strain is kept if it is true.
Curve true_loading(const Curve& measured, const Rules& rules, HardeningCurve& result)
{
  Loading loading = loading_of(measured, rules, result);
  if (rules.measure == Rules::Measure::true_values)
    return loading.curve;
  if (rules.strain == Rules::Strain::plastic)
    for (std::size_t i = 0; i < loading.curve.strain.size(); ++i)
      loading.curve.strain[i] += loading.curve.stress[i] / needed_modulus(rules);
  make_true(loading);
  const char sign = loading.is_compression ? '-' : '+';
  result.notes.push_back(fmt::format("true values of those of a {} test: strain {}ln(1 {} e), stress s (1 {} e)",
                                     loading.is_compression ? "compression" : "tensile",
                                     loading.is_compression ? "-" : "", sign, sign));
  return loading.curve;
}

/// Plastic strains of the loading, and what is known of its elastic part.
std::vector<double> plastic_strains(const Curve& curve, const Rules& rules, HardeningCurve& result)
{
  if (rules.strain == Rules::Strain::plastic && rules.measure == Rules::Measure::true_values)
    return curve.strain;
  const std::optional<FittedLine> line = elastic_line(curve, rules.offset);
  if (line)
    result.slope = line->slope;
  if (rules.slope == Rules::Slope::young_modulus)
  {
    const double modulus = needed_modulus(rules);
    if (line)
      compare_with_modulus(*line, modulus, rules.offset, result);
    result.notes.push_back(
        fmt::format("plastic strain = strain - stress/{:.4g} Pa (Young's modulus){}", modulus,
                    line ? fmt::format("; the elastic part of the curve has a slope of {:.4g} Pa", line->slope) : ""));
    return plastic_strain(curve, modulus, 0.0);
  }
  if (!line)
    throw InputError("has less than 3 points between 10 and 40 % of its yield stress, too few for elastic_slope = "
                     "\"curve\"; allowed: \"young_modulus\"");
  result.zero = -line->intercept / line->slope;
  result.notes.push_back(fmt::format("plastic strain = strain - {:.4g} - stress/{:.4g} Pa (line through the elastic "
                                     "part of the curve)",
                                     result.zero, line->slope));
  return plastic_strain(curve, line->slope, result.zero);
}

/// Points of a hardening curve.
using Points = std::vector<std::pair<double, double>>;

/// The points beyond a plastic strain, in ascending order.
Points beyond(double strain, const std::vector<double>& plastic, const std::vector<double>& stress)
{
  Points points;
  for (std::size_t i = 0; i < plastic.size(); ++i)
    if (plastic[i] > strain && stress[i] > 0.0)
      points.emplace_back(plastic[i], stress[i]);
  std::sort(points.begin(), points.end());
  return points;
}

Points from_first_point(const std::vector<double>& plastic, const std::vector<double>& stress, HardeningCurve& result)
{
  constexpr double rounding = 5e-4;
  const auto first = std::find_if(stress.begin(), stress.end(), [](double s) { return s > 0.0; });
  const auto i = static_cast<std::size_t>(first - stress.begin());
  if (first == stress.end() || std::abs(plastic[i]) > rounding)
    throw InputError(fmt::format("has at its first stress above 0 a plastic strain of {:.4g}, too far from 0 to begin "
                                 "to yield there; allowed: yield_from = \"offset\" or \"fit\"",
                                 first == stress.end() ? 0.0 : plastic[i]));
  result.notes.push_back(fmt::format("yield stress {:.4g} Pa: the first point", *first));
  Points points = beyond(0.0, plastic, stress);
  std::erase(points, std::pair(plastic[i], *first));
  points.emplace(points.begin(), 0.0, *first);
  return points;
}

Points from_offset(const std::vector<double>& plastic, const std::vector<double>& stress, double offset,
                   HardeningCurve& result)
{
  constexpr double far_apart = 0.2;
  const auto at = crossing(plastic, stress, offset);
  if (!at || !(at->stress > 0.0))
  {
    std::string reasons; // such as a modulus in another unit
    for (const Warning& warning : result.warnings)
      reasons += "; " + warning.text;
    throw InputError(fmt::format("reaches a plastic strain of {:.4g} only, so that it has no yield stress at {:g} %; "
                                 "allowed: a smaller yield_offset, below what is reached{}",
                                 *std::max_element(plastic.begin(), plastic.end()), 100.0 * offset, reasons));
  }
  if (at->after - at->before > far_apart * at->stress)
    result.warnings.push_back(
        {"curve_yield",
         fmt::format("its yield stress at {:g} % plastic strain, {:.4g} Pa, lies between points of {:.4g} "
                     "and {:.4g} Pa, which are far apart; more points there make it certain",
                     100.0 * offset, at->stress, at->before, at->after)});
  result.notes.push_back(
      fmt::format("yield stress {:.4g} Pa at {:g} % plastic strain; constant up to there", at->stress, 100.0 * offset));
  Points points = beyond(offset, plastic, stress);
  points.insert(points.begin(), {{0.0, at->stress}, {offset, at->stress}});
  return points;
}

Points from_fit(const std::vector<double>& plastic, const std::vector<double>& stress, double offset,
                HardeningCurve& result)
{
  constexpr std::size_t fewest = 5;
  constexpr double poor = 0.02, far = 0.5;
  Points points = beyond(offset, plastic, stress);
  if (points.size() < fewest)
    throw InputError(fmt::format("has {} points beyond {:g} % plastic strain, too few for yield_from = \"fit\", which "
                                 "needs {}; allowed: more points, a smaller yield_offset, or yield_from = \"offset\"",
                                 points.size(), 100.0 * offset, fewest));
  std::vector<double> e, s;
  for (const auto& [strain, value] : points)
  {
    e.push_back(strain);
    s.push_back(value);
  }
  const FittedLaw law = best_law(e, s);
  const double yield = law.stress(0.0), at_offset = law.stress(offset);
  result.notes.push_back(
      fmt::format("yield stress {:.4g} Pa by {}, fitted to the {} points beyond {:g} % plastic strain "
                  "(root mean square deviation {:.2g} Pa), which is the curve up to there",
                  yield, law.formula, points.size(), 100.0 * offset, law.deviation));
  if (law.deviation > poor * at_offset)
    result.warnings.push_back(
        {"curve_fit", fmt::format("no law fits it well: the root mean square deviation is {:.3g} Pa", law.deviation)});
  if (yield < far * at_offset)
    result.warnings.push_back(
        {"curve_fit", fmt::format("its yield stress by fit, {:.4g} Pa, is far below the stress at {:g} % plastic "
                                  "strain, {:.4g} Pa, and therefore uncertain",
                                  yield, 100.0 * offset, at_offset)});
  Points first{{0.0, yield}};
  for (const double share : {1.0 / 16, 1.0 / 8, 1.0 / 4, 1.0 / 2, 1.0})
    first.emplace_back(share * offset, law.stress(share * offset));
  points.insert(points.begin(), first.begin(), first.end());
  return points;
}

/// Stresses that do not fall: scatter is levelled, more than that is refused, or raised if the user wants it.
std::vector<double> rising(const std::vector<double>& strain, const std::vector<double>& stress, bool monotone,
                           HardeningCurve& result)
{
  constexpr double scatter = 0.02;
  std::vector<double> level = levelled(stress);
  double most = 0.0;
  std::size_t where = 0, changed = 0;
  for (std::size_t i = 0; i < stress.size(); ++i)
  {
    const double change = std::abs(level[i] - stress[i]) / level[i];
    changed += change > 0.0 ? 1 : 0;
    if (change > most)
    {
      most = change;
      where = i;
    }
  }
  if (most <= scatter)
  {
    if (changed > 0)
      result.notes.push_back(
          fmt::format("scatter levelled: {} of {} stresses, by up to {:.2g} %", changed, stress.size(), 100.0 * most));
    return level;
  }
  if (!monotone)
    throw InputError(fmt::format("has stresses that fall by more than scatter: {:.4g} Pa at a plastic strain of {:.4g} "
                                 "is {:.2g} % off a curve that does not fall, and a fall is not computed; allowed: "
                                 "monotone = true, with which the largest stress so far is used",
                                 stress[where], strain[where], 100.0 * most));
  level = stress;
  for (std::size_t i = 1; i < level.size(); ++i)
    level[i] = std::max(level[i], level[i - 1]);
  result.notes.emplace_back("stresses below an earlier one are raised to it");
  return level;
}

/// A curve whose points are used as they are.
HardeningCurve kept(const Curve& measured, const Rules& rules)
{
  HardeningCurve result;
  const Curve curve = loading_of(measured, rules, result).curve;
  const std::string total = "for strains with their elastic part, strain_type = \"total\"";
  if (!(curve.stress.front() > 0.0))
    throw InputError(
        fmt::format("begins with a stress of {:g} Pa; allowed: plastic strains from 0, where the stress is "
                    "the yield stress; {}",
                    curve.stress.front(), total));
  if (curve.strain.front() != 0.0)
    throw InputError(
        fmt::format("begins at a strain of {:g}, but a hardening table must begin at plastic strain 0, "
                    "where the stress is the yield stress; allowed: yield_from = \"offset\" or \"fit\" to find it; {}",
                    curve.strain.front(), total));
  result.plastic_strain = curve.strain;
  result.stress = curve.stress;
  result.loading = curve;
  return result;
}

} // namespace

HardeningCurve hardening_curve(const Curve& measured, const CurveRules& rules)
{
  if (rules.keeps_points())
    return kept(measured, rules);
  HardeningCurve result;
  result.loading = true_loading(measured, rules, result);
  const std::vector<double> plastic = plastic_strains(result.loading, rules, result);
  const auto yield_from = rules.yield_from.value_or(
      rules.strain == Rules::Strain::total ? Rules::YieldFrom::offset : Rules::YieldFrom::first_point);
  const std::vector<double>& stress = result.loading.stress;
  const Points points = yield_from == Rules::YieldFrom::first_point ? from_first_point(plastic, stress, result)
                        : yield_from == Rules::YieldFrom::offset    ? from_offset(plastic, stress, rules.offset, result)
                                                                    : from_fit(plastic, stress, rules.offset, result);
  std::vector<double> chosen;
  for (const auto& [strain, value] : points)
    if (result.plastic_strain.empty() || strain > result.plastic_strain.back())
    {
      result.plastic_strain.push_back(strain);
      chosen.push_back(value);
    }
  result.stress = rising(result.plastic_strain, chosen, rules.monotone, result);
  return result;
}

} // namespace brinell::io
