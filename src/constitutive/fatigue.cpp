// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/constitutive/fatigue.hpp"

#include "brinell/foundation/error.hpp"
#include "critical_plane.hpp"
#include "enclosing_ball.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <numbers>
#include <vector>

namespace brinell::constitutive
{

namespace
{

using Criterion = Fatigue::Criterion;

/// A deviator in an orthonormal basis, so that the length of the vector is sqrt(s : s).
Point<5> vector_of(const SymTensor& t)
{
  const double mean = trace(t) / 3.0;
  return {std::sqrt(1.5) * (t[0] - mean), (t[1] - t[2]) / std::numbers::sqrt2, std::numbers::sqrt2 * t[3],
          std::numbers::sqrt2 * t[4], std::numbers::sqrt2 * t[5]};
}

SymTensor tensor_of(const Point<5>& v)
{
  const double xx = v[0] / std::sqrt(1.5), half = v[1] / std::numbers::sqrt2;
  return {xx,
          half - 0.5 * xx,
          -half - 0.5 * xx,
          v[2] / std::numbers::sqrt2,
          v[3] / std::numbers::sqrt2,
          v[4] / std::numbers::sqrt2};
}

/// The largest value of a function on [0, 1] that has a single maximum there: golden section.
template <typename F>
double largest_on_unit_interval(const F& f)
{
  constexpr double golden = 0.6180339887498949;
  double low = 0.0, high = 1.0;
  for (int i = 0; i < 60; ++i)
  {
    const double a = high - golden * (high - low), b = low + golden * (high - low);
    (f(a) < f(b) ? low : high) = f(a) < f(b) ? a : b;
  }
  return f(0.5 * (low + high));
}

/// Largest gamma_a (1 + k sigma_n) mu over all planes in reversed torsion of amplitude t [Pa].
double fatemi_socie_in_torsion(double k, double t)
{
  return largest_on_unit_interval([&](double s) { return t * std::sqrt(1.0 - s * s) * (1.0 + k * t * s); });
}

/// Largest value of that in reversed bending of amplitude b; the normal of the plane is inclined by asin(sqrt(q)).
double fatemi_socie_in_bending(double k, double b)
{
  return largest_on_unit_interval([&](double q) { return b * std::sqrt(q * (1.0 - q)) * (1.0 + k * b * (1.0 - q)); });
}

double fatemi_socie_sensitivity(double t, double b)
{
  double low = 0.0, high = 1.0 / b;
  const auto bends_less = [&](double k) { return fatemi_socie_in_bending(k, b) < fatemi_socie_in_torsion(k, t); };
  while (bends_less(high) && high < 1e6 / b)
    high *= 2.0;
  for (int i = 0; i < 100; ++i)
    (bends_less(0.5 * (low + high)) ? low : high) = 0.5 * (low + high);
  return 0.5 * (low + high);
}

/// Ratios t / b between which a criterion can be calibrated; at the lower one the normal or hydrostatic stress has no weight.
struct Ratios
{
  double least, below;
};

Ratios ratios_of(Criterion criterion)
{
  constexpr double most = 1.0;
  switch (criterion)
  {
  case Criterion::crossland:
    return {1.0 / std::numbers::sqrt3, most};
  case Criterion::fatemi_socie:
    return {0.5, 0.8}; // beyond, even an infinite weight of the normal stress does not suffice
  default:
    return {0.5, most};
  }
}

double largest_hydrostatic(std::span<const SymTensor> stress)
{
  double largest = -std::numeric_limits<double>::infinity();
  for (const SymTensor& s : stress)
    largest = std::max(largest, trace(s) / 3.0);
  return largest;
}

} // namespace

std::string reason_against(const Fatigue& fatigue)
{
  if (fatigue.criterion == Criterion::none)
    return {};
  const auto [least, below] = ratios_of(fatigue.criterion);
  const double ratio = fatigue.torsion_limit / fatigue.bending_limit;
  if (ratio >= least && ratio < below)
    return {};
  return fmt::format(
      "the limits of torsion and bending have a ratio of {:.4g}; allowed for this criterion: at least {:.4g} "
      "and below {:.4g}",
      ratio, least, below);
}

FatigueCriterion::FatigueCriterion(const Fatigue& fatigue) : kind_(fatigue.criterion)
{
  if (const std::string reason = reason_against(fatigue); !reason.empty())
    throw InternalError("FatigueCriterion: " + reason);
  const double t = fatigue.torsion_limit, b = fatigue.bending_limit, ratio = t / b;
  limit_ = t;
  switch (kind_)
  {
  case Criterion::none:
    limit_ = 1.0;
    break;
  case Criterion::dang_van:
    sensitivity_ = 3.0 * (ratio - 0.5);
    break;
  case Criterion::crossland:
    sensitivity_ = 3.0 * ratio - std::numbers::sqrt3;
    break;
  case Criterion::findley:
    sensitivity_ = (2.0 * ratio - 1.0) / std::sqrt(1.0 - (2.0 * ratio - 1.0) * (2.0 * ratio - 1.0));
    limit_ = t * std::sqrt(1.0 + sensitivity_ * sensitivity_);
    break;
  case Criterion::fatemi_socie:
    sensitivity_ = fatemi_socie_sensitivity(t, b);
    limit_ = fatemi_socie_in_torsion(sensitivity_, t);
    break;
  }
}

double FatigueCriterion::utilisation(const StressCycle& cycle) const
{
  const std::span<const SymTensor> stress = cycle.stress;
  if (stress.empty() || kind_ == Criterion::none)
    return 0.0;
  if (kind_ == Criterion::crossland)
    return (enclosing_ball(stress).radius / std::numbers::sqrt2 + sensitivity_ * largest_hydrostatic(stress)) / limit_;
  if (kind_ == Criterion::dang_van)
  {
    const DeviatorBall ball = enclosing_ball(stress);
    double largest = -std::numeric_limits<double>::infinity();
    for (const SymTensor& s : stress)
    {
      SymTensor mesoscopic = s;
      for (std::size_t c = 0; c < s.size(); ++c)
        mesoscopic[c] -= ball.centre[c];
      largest = std::max(largest, principal_shear(mesoscopic) + sensitivity_ * trace(s) / 3.0);
    }
    return largest / limit_;
  }
  const std::span<const SymTensor> strain = cycle.strain.empty() ? stress : cycle.strain;
  const double k = sensitivity_;
  if (kind_ == Criterion::findley)
    return largest_over_planes(stress, stress, [k](double shear, double normal) { return shear + k * normal; }) /
           limit_;
  return largest_over_planes(stress, strain,
                             [k](double shear, double normal) { return shear * std::max(0.0, 1.0 + k * normal); }) /
         limit_;
}

double principal_shear(const SymTensor& stress)
{
  const SymTensor s = deviator(stress);
  const double j2 = 0.5 * double_contraction(s, s);
  if (j2 <= 0.0)
    return 0.0;
  const auto& [xx, yy, zz, yz, xz, xy] = s;
  const double j3 = xx * (yy * zz - yz * yz) - xy * (xy * zz - yz * xz) + xz * (xy * yz - yy * xz);
  const double cosine = std::clamp(1.5 * std::numbers::sqrt3 * j3 / (j2 * std::sqrt(j2)), -1.0, 1.0);
  // The Lode angle is between 0 and pi/3: s1 - s3 = 2 sqrt(J2) cos(angle - pi/6).
  return std::sqrt(j2) * std::cos(std::acos(cosine) / 3.0 - std::numbers::pi / 6.0);
}

DeviatorBall enclosing_ball(std::span<const SymTensor> stress)
{
  std::vector<Point<5>> points(stress.size());
  std::ranges::transform(stress, points.begin(), vector_of);
  const Ball<5> ball = smallest_ball<5>(points);
  return {tensor_of(ball.centre), ball.radius};
}

} // namespace brinell::constitutive
