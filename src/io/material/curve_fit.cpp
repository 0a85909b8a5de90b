// SPDX-License-Identifier: BSD-3-Clause
#include "curve_fit.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <numeric>
#include <vector>

namespace brinell::io
{

namespace
{

using Function = std::function<double(double)>;

/// Place of the smallest value in [first, last]: the best of many equal intervals, then golden sections around it.
double place_of_least(const Function& value, double first, double last)
{
  constexpr int intervals = 60, sections = 60;
  const auto at = [&](int i) { return first + (last - first) * i / intervals; };
  int best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= intervals; ++i)
    if (const double v = value(at(i)); v < least)
    {
      least = v;
      best = i;
    }
  double low = at(std::max(best - 1, 0)), high = at(std::min(best + 1, intervals));
  const double golden = 0.5 * (std::sqrt(5.0) - 1.0);
  for (int i = 0; i < sections; ++i)
  {
    const double a = high - golden * (high - low), b = low + golden * (high - low);
    (value(a) < value(b) ? high : low) = value(a) < value(b) ? b : a;
  }
  return 0.5 * (low + high);
}

std::vector<double> mapped(std::span<const double> values, const Function& function)
{
  std::vector<double> result(values.size());
  std::transform(values.begin(), values.end(), result.begin(), function);
  return result;
}

double squares_of(const Function& law, std::span<const double> strain, std::span<const double> stress)
{
  double sum = 0.0;
  for (std::size_t i = 0; i < strain.size(); ++i)
    sum += (law(strain[i]) - stress[i]) * (law(strain[i]) - stress[i]);
  return sum;
}

/// A fit, or nothing if it is no hardening law.
struct Candidate
{
  std::string formula;
  Function stress;
};

/// A line that falls, as through scattered stresses of a material that does not harden, becomes a constant.
FittedLine without_fall(FittedLine line, std::span<const double> y)
{
  if (line.slope < 0.0)
    line = {std::accumulate(y.begin(), y.end(), 0.0) / static_cast<double>(y.size()), 0.0, line.squares};
  return line;
}

/// S_y + amount shape(e, parameter): linear in S_y and amount for each parameter.
template <typename Shape>
std::pair<double, FittedLine> fitted_shape(std::span<const double> strain, std::span<const double> stress,
                                           const Shape& shape, double first, double last)
{
  const auto line = [&](double logarithm)
  {
    const double parameter = std::exp(logarithm);
    const std::vector<double> x = mapped(strain, [&](double e) { return shape(e, parameter); });
    return fitted_line(x, stress).value_or(FittedLine{0.0, 0.0, std::numeric_limits<double>::infinity()});
  };
  const auto squares = [&](double logarithm)
  {
    const FittedLine fit = line(logarithm);
    return fit.intercept > 0.0 && fit.slope >= 0.0 ? fit.squares : std::numeric_limits<double>::infinity();
  };
  const double best = place_of_least(squares, std::log(first), std::log(last));
  return {std::exp(best), without_fall(line(best), stress)};
}

Candidate ludwik(std::span<const double> strain, std::span<const double> stress)
{
  const auto shape = [](double e, double exponent) { return std::pow(e, exponent); };
  const auto [exponent, line] = fitted_shape(strain, stress, shape, 0.02, 1.0);
  return {fmt::format("Ludwik's law, {:.4g} Pa + {:.4g} Pa e^{:.4g}", line.intercept, line.slope, exponent),
          [shape, exponent = exponent, line = line](double e)
          { return line.intercept + line.slope * shape(e, exponent); }};
}

Candidate voce(std::span<const double> strain, std::span<const double> stress)
{
  const auto shape = [](double e, double rate) { return -std::expm1(-rate * e); };
  const double last = *std::max_element(strain.begin(), strain.end());
  const auto [rate, line] = fitted_shape(strain, stress, shape, 0.01 / last, 100.0 / last);
  return {fmt::format("Voce's law, {:.4g} Pa + {:.4g} Pa (1 - exp(-{:.4g} e))", line.intercept, line.slope, rate),
          [shape, rate = rate, line = line](double e) { return line.intercept + line.slope * shape(e, rate); }};
}

/// coefficient (offset + e)^exponent: a line in logarithms for each offset.
Candidate swift(std::span<const double> strain, std::span<const double> stress)
{
  const std::vector<double> y = mapped(stress, [](double s) { return std::log(s); });
  const auto line = [&](double logarithm)
  {
    const double offset = std::exp(logarithm);
    return *fitted_line(mapped(strain, [&](double e) { return std::log(offset + e); }), y);
  };
  const double last = *std::max_element(strain.begin(), strain.end());
  const double best =
      place_of_least([&](double logarithm) { return line(logarithm).squares; }, std::log(1e-5 * last), std::log(last));
  const FittedLine fit = without_fall(line(best), y);
  const double offset = std::exp(best), coefficient = std::exp(fit.intercept), exponent = fit.slope;
  return {fmt::format("Swift's law, {:.4g} Pa ({:.4g} + e)^{:.4g}", coefficient, offset, exponent),
          [=](double e) { return coefficient * std::pow(offset + e, exponent); }};
}

} // namespace

std::optional<FittedLine> fitted_line(std::span<const double> x, std::span<const double> y)
{
  const auto n = static_cast<double>(x.size());
  const double mean_x = std::accumulate(x.begin(), x.end(), 0.0) / n,
               mean_y = std::accumulate(y.begin(), y.end(), 0.0) / n;
  double xx = 0.0, xy = 0.0, yy = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i)
  {
    xx += (x[i] - mean_x) * (x[i] - mean_x);
    xy += (x[i] - mean_x) * (y[i] - mean_y);
    yy += (y[i] - mean_y) * (y[i] - mean_y);
  }
  if (!(xx > 0.0))
    return std::nullopt;
  const double slope = xy / xx;
  return FittedLine{mean_y - slope * mean_x, slope, std::max(yy - slope * xy, 0.0)};
}

FittedLaw best_law(std::span<const double> strain, std::span<const double> stress)
{
  FittedLaw best;
  double least = std::numeric_limits<double>::infinity();
  for (Candidate candidate : {swift(strain, stress), ludwik(strain, stress), voce(strain, stress)})
    if (const double squares = squares_of(candidate.stress, strain, stress); squares < least)
    {
      least = squares;
      best = {std::move(candidate.formula), std::sqrt(squares / static_cast<double>(strain.size())),
              std::move(candidate.stress)};
    }
  return best;
}

} // namespace brinell::io
