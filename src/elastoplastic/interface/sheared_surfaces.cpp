// SPDX-License-Identifier: BSD-3-Clause
#include "sheared_surfaces.hpp"

#include "brinell/foundation/symmetry.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace brinell::elastoplastic
{

namespace
{

constexpr Elastic unit_body{1.0, 0.0};
constexpr Elastic rigid_body{std::numeric_limits<double>::infinity(), 0.0};

/// Coupling weight (1 - 2 nu)/(2 mu) [1/Pa]; it is 1 for the unit body.
double weight_of_coupling(const Elastic& elastic)
{
  return elastic.is_rigid() ? 0.0 : (1.0 - 2.0 * elastic.poisson_ratio) / (2.0 * elastic.shear_modulus());
}

/// Displacement along z or x by a load of pressure and shear along x; on a mirrored grid one side of the fields, which are even,
/// and then the other.
void displace(const halfspace::SurfaceCompliance& compliance, const halfspace::SurfaceLoad& load,
              const halfspace::SurfaceDisplacement& out)
{
  compliance.apply(load, out);
  const SurfaceGrid& grid = compliance.grid();
  for (const std::span<double>& field : {out.z, out.x})
    if (grid.is_mirrored_y && !field.empty())
      complete_in_y(grid, 1.0, field.data(), field.size());
}

bool is_rigid(const ElasticStack& stack)
{
  return stack.is_homogeneous() && stack.substrate.is_rigid();
}

} // namespace

void add_scaled(double factor, std::span<const double> field, std::span<double> to)
{
  for (std::size_t i = 0; i < field.size(); ++i)
    to[i] += factor * field[i];
}

ShearedSurfaces::ShearedSurfaces(const SurfaceGrid& grid, const ElasticStack& lower, const ElasticStack& upper,
                                 bool couples, double reference)
    : pair_(grid, lower, upper, reference), unit_(grid, unit_body, rigid_body, reference),
      is_layered_(!lower.merged().is_homogeneous() || !upper.merged().is_homogeneous()), couples_(couples)
{
  const ElasticStack rigid{{}, rigid_body};
  if (is_layered_)
  {
    changes_gap_ = couples && pair_.couples();
    // The body without layers is computed by itself, if there is one: its operator is planned in no time.
    if (is_rigid(lower) || is_rigid(upper))
      lower_ = is_rigid(lower) ? Lower::is_rigid : Lower::is_pair;
    else
      lower_ = upper.merged().is_homogeneous() ? Lower::is_rest : Lower::is_alone;
    if (lower_ == Lower::is_rest)
      alone_.emplace(grid, rigid, upper, reference);
    else if (lower_ == Lower::is_alone)
      alone_.emplace(grid, lower, rigid, reference);
    return;
  }
  const Elastic &one = lower.top(), &other = upper.top();
  lower_weight_ = weight_of_coupling(one);
  upper_weight_ = weight_of_coupling(other);
  // Without coupling both bodies get the mean of their weights: the gap does not change, and the energy balance still holds.
  if (!couples)
    lower_weight_ = upper_weight_ = 0.5 * (lower_weight_ + upper_weight_);
  changes_gap_ = lower_weight_ != upper_weight_;
  if (one == other)
    lower_share_ = 0.5;
  else if (other.is_rigid())
    lower_share_ = 1.0;
  else if (!one.is_rigid())
    alone_.emplace(grid, one, rigid_body, reference);
}

void ShearedSurfaces::find_depth(std::span<const double> shear, std::vector<double>& depth) const
{
  if (!changes_gap_)
    std::fill(depth.begin(), depth.end(), 0.0);
  else if (is_layered_)
    displace(pair_, {.shear_x = shear}, {.z = depth});
  else
  {
    displace(unit_, {.shear_x = shear}, {.z = depth});
    for (double& u : depth)
      u *= lower_weight_ - upper_weight_;
  }
}

void ShearedSurfaces::find_lower_depth(std::span<const double> shear, std::span<const double> depth,
                                       std::vector<double>& lower) const
{
  if (!is_layered_)
  {
    displace(unit_, {.shear_x = shear}, {.z = lower});
    for (double& u : lower)
      u *= lower_weight_;
    return;
  }
  std::vector<double> of_pair(depth.begin(), depth.end());
  if (!couples_)
    displace(pair_, {.shear_x = shear}, {.z = of_pair});
  lower = of_pair;
  take_lower({.shear_x = shear}, &lower, nullptr);
  if (!couples_) // the mean of the lower surface and of the upper one in the mirror
    add_scaled(-0.5, of_pair, lower);
}

void ShearedSurfaces::take_lower(const Load& load, std::vector<double>* z, std::vector<double>* x) const
{
  if (lower_ == Lower::is_pair)
    return;
  std::vector<double> along_z(z != nullptr ? z->size() : 0), along_x(x != nullptr ? x->size() : 0);
  if (lower_ != Lower::is_rigid)
    displace(*alone_, load, {.z = along_z, .x = along_x});
  for (const auto& [own, of_pair] : {std::pair{&along_z, z}, {&along_x, x}})
  {
    if (of_pair == nullptr)
      continue;
    if (lower_ == Lower::is_rest)
      add_scaled(-1.0, *own, *of_pair);
    else
      *of_pair = *own;
  }
}

void ShearedSurfaces::add_along_of_stacks(const Load& pressure, const Load& shear, std::vector<double>& lower,
                                          std::vector<double>& upper) const
{
  std::vector<double> of_pair(lower.size()), of_lower;
  const auto add_both = [&](const Load& load, double share_of_upper)
  {
    displace(pair_, load, {.x = of_pair});
    of_lower = of_pair;
    take_lower(load, nullptr, &of_lower);
    add_scaled(1.0, of_lower, lower);
    add_scaled(1.0, of_lower, upper);
    add_scaled(share_of_upper - 1.0, of_pair, lower);
    add_scaled(-share_of_upper, of_pair, upper);
  };
  // Without coupling, the mean of both surfaces.
  add_both(pressure, couples_ ? 1.0 : 0.5);
  add_both(shear, 1.0);
}

/// Pressure displaces both surfaces in the same direction along x; shear displaces them in opposite directions.
void ShearedSurfaces::add_along(std::span<const double> pressure, std::span<const double> shear,
                                std::vector<double>& lower, std::vector<double>& upper) const
{
  if (is_layered_)
  {
    add_along_of_stacks({.pressure = pressure}, {.shear_x = shear}, lower, upper);
    return;
  }
  std::vector<double> unit_displacement(lower.size()), of_pair(lower.size());
  displace(unit_, {.pressure = pressure}, {.x = unit_displacement});
  displace(pair_, {.shear_x = shear}, {.x = of_pair});
  add_scaled(lower_weight_, unit_displacement, lower);
  add_scaled(upper_weight_, unit_displacement, upper);
  std::vector<double> lower_by_shear = of_pair;
  if (alone_)
    displace(*alone_, {.shear_x = shear}, {.x = lower_by_shear});
  else
    std::for_each(lower_by_shear.begin(), lower_by_shear.end(), [this](double& u) { u *= lower_share_; });
  add_scaled(1.0, lower_by_shear, lower);
  add_scaled(1.0, lower_by_shear, upper);
  add_scaled(-1.0, of_pair, upper);
}

} // namespace brinell::elastoplastic
