// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/green/elastic_stack.hpp"

#include <array>
#include <cstddef>
#include <functional>
#include <vector>

namespace brinell::green
{

/// A unit traction on the surface with one wavevector, in the frame of the wavevector: l along it, t across it, z down.
enum class WaveLoad
{
  pressure,
  along, ///< shear along l
  across ///< shear along t
};

/// Stress of a wave, per unit of the load. Values that are a quarter period ahead of the load are multiplied by i:
/// lz for a pressure; ll, tt and zz for a shear along; lt for a shear across.
struct WaveStress
{
  double ll = 0.0, tt = 0.0, zz = 0.0, lz = 0.0, lt = 0.0, tz = 0.0;
};

/// Displacement of the surface of a stack by a wave of unit traction [m/Pa].
struct WaveCompliance
{
  double normal = 0.0;   ///< along z by a pressure
  double coupling = 0.0; ///< along l by a pressure, without the factor -i; along z by a shear along l, without i
  double along = 0.0;    ///< along l by a shear along l
  double across = 0.0;   ///< along t by a shear along t
};

/// Elastic waves of one wavenumber in a stack: docs/theory/stacks.md.
///
/// In each layer the field is a wave that decays downwards from the top of the layer and one that decays upwards from its
/// bottom; both have the form of the waves that a sheet of plastic strain emits (green::SheetWave, in units of stress), and the
/// layers beneath enter through the matrix that reflects one into the other. Only decaying exponentials occur, and the waves
/// remain independent for layers that are thin compared with the wave: nothing overflows or cancels for thick layers and short
/// waves or thin layers and long waves.
class StackWave
{
public:
  /// @param k  wavenumber [rad/m], > 0
  /// @throws InputError if a thickness or a constant is not allowed
  StackWave(const ElasticStack& stack, double k);

  /// Amplitudes of a wave in one direction [Pa]: zz = (s c - a) e^{-s}, ll = (a + (2 - s) c) e^{-s}, lt = w e^{-s} with s = k times
  /// the distance travelled.
  struct Wave
  {
    double a = 0.0, c = 0.0, w = 0.0;
  };
  struct Waves
  {
    Wave down; ///< at the top of the layer
    Wave up;   ///< at its bottom
  };
  /// Waves in all layers and, last, in the substrate.
  using Field = std::vector<Waves>;

  /// Maps amplitudes to amplitudes: the part of a and c, and that of w.
  struct Matrix
  {
    double aa = 0.0, ac = 0.0, ca = 0.0, cc = 0.0, ww = 0.0;
    [[nodiscard]] Wave operator*(const Wave& wave) const
    {
      return {aa * wave.a + ac * wave.c, ca * wave.a + cc * wave.c, ww * wave.w};
    }
  };
  struct Layer
  {
    double top = 0.0, x = 0.0; ///< depth [m], and k times the thickness; infinite for the substrate
    double nu = 0.0, mu = 0.0;
    Matrix reflected;   ///< from down to up, at the bottom
    Matrix transmitted; ///< from down, at the bottom, to down at the top of the next layer
    Matrix lifted;      ///< from up, at the top of the next layer, to up at the bottom
    Matrix returned;    ///< from up to down, both at the top of the next layer
  };
  /// The layers and, unless it is rigid, the substrate.
  [[nodiscard]] const std::vector<Layer>& layers() const { return layers_; }
  [[nodiscard]] double wavenumber() const { return k_; }
  /// From up to down at the surface, which is free of traction: of waves that come from sources below, including those that return
  /// again and again.
  [[nodiscard]] Matrix from_free_surface() const;
  /// The wave at the distance s from its origin, with this point as the origin.
  [[nodiscard]] static Wave travelled(const Wave& wave, double s);
  /// Reflection by everything beneath the top of a layer.
  [[nodiscard]] static Matrix seen_from_top(const Layer& layer);

  [[nodiscard]] WaveCompliance compliance() const;
  [[nodiscard]] Field field_of(WaveLoad load) const;
  /// Waves that sources within the layers cause at the interfaces and at the free surface, without those of the sources.
  /// @param arriving  waves of the sources of each layer: downwards at its bottom, upwards at its top
  [[nodiscard]] Field field_of(const Field& arriving) const;
  /// Stress at a depth [-], and its mean from one depth to a larger one in the same layer.
  /// @param layer  in which the depths lie: their boundary belongs to both layers
  [[nodiscard]] WaveStress stress(WaveLoad load, const Field& field, std::size_t layer, double depth) const;
  [[nodiscard]] WaveStress mean_stress(WaveLoad load, const Field& field, std::size_t layer, double from,
                                       double to) const;
  /// Displacement at a depth [m/Pa], as (l, z, t): without the factors of WaveCompliance.
  [[nodiscard]] std::array<double, 3> displacement(WaveLoad load, const Field& field, std::size_t layer,
                                                   double depth) const;

private:
  static void join(Layer& upper, const Layer& lower);
  static void clamp(Layer& layer);

  double k_;
  bool is_on_rigid_base_;
  std::vector<Layer> layers_; ///< the last one is the substrate, unless that is rigid
};

/// The largest relative change of a property of waves, to + or -, between two wavenumbers.
///
/// Of the compliance, every pressure made of these waves does at most this share more work, or less, and so does the least complementary
/// energy of a contact, which no admissible pressure undercuts.
/// @param from, to            the property at a wavenumber, > 0
/// @param k_least, k_largest  [rad/m], > 0; 16 wavenumbers to the octave are compared
[[nodiscard]] double largest_change(const std::function<double(double k)>& from,
                                    const std::function<double(double k)>& to, double k_least, double k_largest);

/// Change of the compliance: by how much more the surface of one body gives way to a pressure than that of another.
/// @throws InputError if a thickness or a constant is not allowed
[[nodiscard]] double change_of_compliance(const ElasticStack& from, const ElasticStack& to, double k_least,
                                          double k_largest);

} // namespace brinell::green
