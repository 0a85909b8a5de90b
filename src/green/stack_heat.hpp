// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/green/elastic_stack.hpp"
#include "brinell/green/stack.hpp"
#include "brinell/green/thermal_stack.hpp"

#include <complex>
#include <cstddef>
#include <vector>

namespace brinell::green
{

/// Temperature of one wave along the surface of a stack, after a unit of heat per area has entered the surface at once, in the Laplace
/// domain of the time: docs/theory/heat.md (coated-heat).
///
/// In each layer the temperature is a wave that decays downwards from its top and one that decays upwards from its bottom. Only
/// decaying exponentials occur.
class StackHeat
{
public:
  using Complex = std::complex<double>;
  /// @param k          wavenumber along the surface [rad/m], >= 0
  /// @param rate       Laplace variable [1/s] of e^{kappa k^2 t} times the temperature, not real and below 0
  /// @param reference  this kappa [m^2/s], at most the smallest diffusivity of the stack
  StackHeat(const ThermalStack& stack, double k, Complex rate, double reference);

  /// T = down e^{-q (z - top)} + up e^{-q (bottom - z)} [K m^2 s/J].
  struct Layer
  {
    double top, thickness; ///< [m]; infinite thickness of the substrate
    Complex q, down, up;
  };
  [[nodiscard]] const std::vector<Layer>& layers() const { return layers_; }
  [[nodiscard]] double wavenumber() const { return k_; }
  /// Temperature of the surface, and its excess over that of a half space of the first layer.
  [[nodiscard]] Complex at_surface() const { return at_surface_; }
  [[nodiscard]] Complex excess_at_surface() const { return excess_; }
  [[nodiscard]] Complex at(std::size_t layer, double depth) const;

private:
  double k_;
  std::vector<Layer> layers_;
  Complex at_surface_, excess_;
};

/// Stress at a depth and displacement of the surface by one wave of temperature in a stack whose surface is free of traction, in the
/// frame of the wavevector: docs/theory/heat.md (coated-stress). tt = nu (ll + zz) - E alpha T; lt and tz are zero.
class StackExpansion
{
public:
  using Complex = std::complex<double>;
  /// @param elastic  with the layers of `thermal`; the substrate is not rigid
  /// @param k        > 0, or 0: the uniform part of a surface that is held in its plane
  StackExpansion(const ElasticStack& elastic, const ThermalStack& thermal, double k);

  /// @param layer  in which the depth lies
  void add_depth(std::size_t layer, double depth);
  /// Stress at the added depths.
  struct Stress
  {
    Complex temperature, ll, zz; ///< [K], [Pa], per unit of heat as in StackHeat
    Complex lz;                  ///< without the factor i
  };
  /// Displacement of the surface.
  struct Displacement
  {
    Complex z; ///< into the body
    Complex l; ///< without the factor -i
  };
  void find(const StackHeat& heat, std::vector<Stress>& stresses, Displacement& displacement) const;

private:
  /// Factors of waves that the heat of the layers sends to their ends.
  struct Factors
  {
    double ll = 0.0, zz = 0.0, lz = 0.0, u_l = 0.0, u_z = 0.0;
  };
  struct Depth
  {
    std::size_t layer;
    double depth;
    std::vector<Factors> factors; ///< downwards at the bottom and upwards at the top of each layer, in turns
  };
  [[nodiscard]] std::vector<Complex> arriving(const StackHeat& heat) const;
  void find_uniform(const StackHeat& heat, std::vector<Stress>& stresses, Displacement& displacement) const;

  double k_;
  std::vector<double> mu_, strain_; ///< of the layers: shear modulus, alpha (1 + nu)/(1 - nu)
  StackWave wave_;
  std::vector<StackWave::Field> fields_; ///< of a unit wave that arrives at each end
  std::vector<Depth> depths_;
  Depth surface_{0, 0.0, {}};
};

} // namespace brinell::green
