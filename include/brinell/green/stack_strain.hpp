// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/green/stack.hpp"

#include <complex>

namespace brinell::green
{

/// Amplitudes of an eigenstrain that is a wave along the surface, in the frame of the wavevector: any strain, also one that changes
/// the volume.
struct WaveStrain
{
  double ll = 0.0, tt = 0.0, zz = 0.0, lz = 0.0, lt = 0.0, tz = 0.0;
};

/// Amplitudes of the fields that such a strain causes: stress [Pa] and displacement [m], or per thickness of a sheet.
struct StrainedField
{
  std::complex<double> ll{}, tt{}, zz{}, lz{}, lt{}, tz{};
  std::complex<double> u_l{}, u_z{}, u_t{};
};

/// Fields of one wave of eigenstrain within a layer of a stack whose surface is free of traction: docs/theory/stacks.md
/// (stack-strain). Slow and obvious: one source, one point; halfspace::StackStress is the operator on cells.
class StackStrain
{
public:
  /// A strain that is uniform from one depth to a larger one, both in the same layer (or at its ends). At these depths the fields are
  /// those within the strain.
  StackStrain(const StackWave& wave, std::size_t layer, double from, double to, const WaveStrain& strain);
  /// A thin sheet, per thickness; its fields do not contain the stress within the sheet, and at its depth are the mean of both sides.
  [[nodiscard]] static StackStrain sheet(const StackWave& wave, std::size_t layer, double depth,
                                         const WaveStrain& strain);

  /// @param layer  in which the depth lies: an interface belongs to both layers
  [[nodiscard]] StrainedField at(std::size_t layer, double depth) const;

private:
  /// Amplitudes of a wave, as StackWave::Wave.
  struct Wave
  {
    std::complex<double> a{}, c{}, w{};
  };
  StackStrain(const StackWave& wave, std::size_t layer, double from, double to, const WaveStrain& strain,
              bool is_sheet);
  [[nodiscard]] Wave emitted(double thickness, double direction) const;
  void add_own(double depth, StrainedField& field) const;
  void add_wave(const Wave& wave, double distance, double direction, const StackWave::Layer& medium, double share,
                StrainedField& field) const;

  const StackWave& wave_;
  std::size_t layer_;
  double from_, to_;
  WaveStrain strain_;
  bool is_sheet_;
  StackWave::Field real_, imaginary_; ///< waves from the interfaces and the surface
};

} // namespace brinell::green
