// SPDX-License-Identifier: BSD-3-Clause
#include "loading.hpp"

#include "brinell/foundation/error.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <iterator>
#include <numeric>

namespace brinell::io
{

namespace
{

void require_finite(const Curve& curve)
{
  if (curve.strain.size() != curve.stress.size() || curve.strain.empty())
    throw InputError(fmt::format("has {} strains and {} stresses; allowed: as many of one as of the other",
                                 curve.strain.size(), curve.stress.size()));
  for (std::size_t i = 0; i < curve.strain.size(); ++i)
    if (!std::isfinite(curve.strain[i]) || !std::isfinite(curve.stress[i]))
      throw InputError(fmt::format("has {:g} Pa at a strain of {:g} as point {}; allowed: finite numbers",
                                   curve.stress[i], curve.strain[i], i + 1));
}

double largest(const std::vector<double>& values)
{
  return *std::max_element(values.begin(), values.end());
}

/// Magnitudes of a curve in compression, whose strains and stresses may be below 0.
void make_upright(Loading& loading, CurveRules::Test test, HardeningCurve& report)
{
  Curve& curve = loading.curve;
  const auto falls = [](const std::vector<double>& values)
  { return -*std::min_element(values.begin(), values.end()) > largest(values); };
  const bool strain_falls = falls(curve.strain), stress_falls = falls(curve.stress);
  if (strain_falls != stress_falls)
    throw InputError(fmt::format("has strains mainly {} 0, but stresses mainly {} 0; allowed: both above 0, or both "
                                 "below 0 in compression",
                                 strain_falls ? "below" : "above", stress_falls ? "below" : "above"));
  if (strain_falls)
  {
    for (std::vector<double>* values : {&curve.strain, &curve.stress})
      for (double& value : *values)
        value = -value;
    report.notes.emplace_back("strains and stresses below 0, as in compression: their magnitudes are used");
  }
  loading.is_compression =
      test == CurveRules::Test::compression || (test == CurveRules::Test::automatic && strain_falls);
  if (strain_falls && test == CurveRules::Test::tension)
    throw InputError("has strains and stresses below 0; allowed with test = \"tension\": above 0");
}

/// Leaves out the points at strains below an earlier one: unloading, reloading up to there, and steps back of a measurement that
/// scatters.
void leave_out_loops(Curve& curve, HardeningCurve& report)
{
  constexpr double unloaded = 0.9; // share of the stress before: below is unloading, above is scatter
  Curve kept;
  std::size_t loops = 0, left_out = 0;
  bool in_loop = false;
  for (std::size_t i = 0; i < curve.strain.size(); ++i)
    if (kept.strain.empty() || curve.strain[i] >= kept.strain.back())
    {
      kept.strain.push_back(curve.strain[i]);
      kept.stress.push_back(curve.stress[i]);
      in_loop = false;
    }
    else
    {
      ++left_out;
      if (!in_loop && curve.stress[i] < unloaded * kept.stress.back())
      {
        in_loop = true;
        ++loops;
      }
    }
  if (left_out > 0)
    report.notes.push_back(fmt::format("left out: {} at strains below an earlier one{}",
                                       left_out == 1 ? "1 point" : fmt::format("{} points", left_out),
                                       loops == 0   ? ""
                                       : loops == 1 ? " (1 unloading)"
                                                    : fmt::format(" ({} unloadings)", loops)));
  curve = std::move(kept);
}

/// One point for each strain: with the mean of its stresses while they rise, as of strains that were rounded, and with
/// the largest while they fall, as during a hold.
void merge_equal_strains(Curve& curve, HardeningCurve& report)
{
  Curve merged;
  std::size_t count = 0;
  for (std::size_t i = 0; i < curve.strain.size();)
  {
    std::size_t end = i + 1;
    while (end < curve.strain.size() && curve.strain[end] == curve.strain[i])
      ++end;
    const auto first = curve.stress.begin() + static_cast<std::ptrdiff_t>(i),
               last = curve.stress.begin() + static_cast<std::ptrdiff_t>(end);
    const double mean = std::accumulate(first, last, 0.0) / static_cast<double>(end - i);
    merged.strain.push_back(curve.strain[i]);
    merged.stress.push_back(end == i + 1 ? *first : *(last - 1) < *first ? *std::max_element(first, last) : mean);
    count += end - i - 1;
    i = end;
  }
  if (count > 0)
    report.notes.push_back(
        fmt::format("{} at a repeated strain joined with the point before: the mean of stresses that rise, the largest "
                    "of stresses that fall",
                    count == 1 ? "1 point" : fmt::format("{} points", count)));
  curve = std::move(merged);
}

/// Leaves out what follows the largest force of a tensile test, where the specimen necks, or a fall to fracture.
void leave_out_end(Loading& loading, const CurveRules& rules, HardeningCurve& report)
{
  constexpr double scatter = 0.02, far = 5.0, large_part = 0.2;
  Curve& curve = loading.curve;
  const auto peak = std::max_element(curve.stress.begin(), curve.stress.end());
  const auto at_peak = static_cast<std::size_t>(peak - curve.stress.begin());
  const bool necks = rules.measure == CurveRules::Measure::engineering && !loading.is_compression &&
                     curve.strain[at_peak] > far * rules.offset;
  std::size_t last = at_peak;
  for (std::size_t i = at_peak; !necks && i < curve.stress.size(); ++i)
    if (curve.stress[i] >= (1.0 - scatter) * *peak)
      last = i;
  if (last + 1 == curve.stress.size())
    return;
  const double end = curve.strain[last], whole = curve.strain.back();
  const std::string text =
      fmt::format("left out: {} points beyond a strain of {:.4g}, after the largest {}, {:.4g} Pa; {}",
                  curve.stress.size() - last - 1, end, necks ? "force" : "stress", *peak,
                  necks ? "the specimen necks there" : "a fall of the stress is not computed");
  if (!necks && whole - end > large_part * whole)
    report.warnings.push_back({"curve_end", text});
  else
    report.notes.push_back(text);
  curve.strain.resize(last + 1);
  curve.stress.resize(last + 1);
}

} // namespace

Loading loading_of(const Curve& measured, const CurveRules& rules, HardeningCurve& report)
{
  require_finite(measured);
  Loading loading{measured};
  make_upright(loading, rules.test, report);
  if (!rules.keeps_points()) // otherwise strains that go back are errors of the table
    leave_out_loops(loading.curve, report);
  merge_equal_strains(loading.curve, report);
  if (!rules.keeps_points())
    leave_out_end(loading, rules, report);
  return loading;
}

void make_true(Loading& loading)
{
  const double sign = loading.is_compression ? -1.0 : 1.0;
  for (std::size_t i = 0; i < loading.curve.strain.size(); ++i)
  {
    double& strain = loading.curve.strain[i];
    if (!(1.0 + sign * strain > 0.0))
      throw InputError(fmt::format("has an engineering strain of {:g} in compression; allowed: below 1", strain));
    loading.curve.stress[i] *= 1.0 + sign * strain;
    strain = sign * std::log1p(sign * strain);
  }
}

std::vector<double> levelled(const std::vector<double>& stress)
{
  struct Block
  {
    double sum;
    std::size_t count;
    [[nodiscard]] double mean() const { return sum / static_cast<double>(count); }
  };
  std::vector<Block> blocks;
  for (const double value : stress)
  {
    blocks.push_back({value, 1});
    while (blocks.size() > 1 && blocks.back().mean() < blocks[blocks.size() - 2].mean())
    {
      const Block last = blocks.back();
      blocks.pop_back();
      blocks.back() = {blocks.back().sum + last.sum, blocks.back().count + last.count};
    }
  }
  std::vector<double> result;
  for (const Block& block : blocks)
    result.insert(result.end(), block.count, block.mean());
  return result;
}

} // namespace brinell::io
