// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/share.hpp"
#include "brinell/green/stack.hpp"
#include "eigenstrain_stress.hpp"
#include "stack_parts.hpp"

#include <array>
#include <vector>

namespace brinell::halfspace
{

/// Plastic strain -> residual stress in a layered body whose surface is free of traction: EigenstrainStress for a stack.
///
/// Within a material the waves of the strain are the running sums of a homogeneous body. At its ends they are reflected and
/// transmitted by real matrices, one set per wavenumber: docs/theory/stacks.md (stack-sources). A first pass from the deepest strain
/// upwards sums the waves that arrive at the ends of each material; the matrices give the waves that start there; two
/// passes, upwards and downwards, add the stress. The strain is constant in a layer of cells and the stress its mean, so that the
/// operator is symmetric.
class StackStress
{
public:
  /// @param grid      whose layers of cells end at the interfaces (`require_aligned`)
  /// @param fft  see EigenstrainStress
  /// @param blocks         of wavenumbers that will be asked for
  StackStress(const VolumeGrid& grid, const ElasticStack& stack, const BlockedFft& fft,
              const layer_waves::Shortest& shortest, const Portion& blocks);
  StackStress(const StackStress&) = delete;
  StackStress& operator=(const StackStress&) = delete;

  /// Waves at the ends of a material: those of its sources, those that come from beneath, and those that start at its ends.
  struct Ends
  {
    green::SheetWave<ComplexLanes> source_down, up_at_top, from_beneath, down, up;
  };
  struct Scratch
  {
    AlignedVector<layer_waves::Layer> layers; ///< [layer][row]
    AlignedVector<Ends> ends;                 ///< [material][row]
  };
  [[nodiscard]] Scratch make_scratch() const;
  /// Memory of the numbers of all wavenumbers [bytes].
  [[nodiscard]] double bytes() const
  {
    return static_cast<double>(factors_.size() * sizeof(Factors) + surface_.size() * sizeof(Matrix) +
                               couplings_.size() * sizeof(Coupling));
  }

  /// As EigenstrainStress::apply.
  void apply(int block, const SpectrumRows& rows, const EigenstrainStress::Spectra& spectra, Scratch& scratch) const;

private:
  using Factors = layer_waves::Factors;
  using Point = green::SheetWave<ComplexLanes>;
  /// A matrix of StackWave for neighbouring wavenumbers.
  struct Matrix
  {
    Lanes aa{}, ac{}, ca{}, cc{}, ww{};
    void set(std::size_t lane, const green::StackWave::Matrix& matrix, double in_plane, double across);
    Point operator*(const Point& wave) const
    {
      return {aa * wave.a + ac * wave.c, ca * wave.a + cc * wave.c, ww * wave.w};
    }
  };
  /// A material and the interface beneath it.
  struct Coupling
  {
    Lanes decay{}, way{}; ///< over the material: e^{-x} and x
    Matrix reflected, transmitted, lifted, returned;
  };
  struct Stiffness
  {
    double in_plane, across, nu;
  };
  struct Tile;
  void set(int column, int row, const ElasticStack& stack, const layer_waves::Shortest& shortest);
  void gather(const EigenstrainStress::Spectra& spectra, const Tile& tile, Scratch& scratch) const;
  void join(const Tile& tile, Scratch& scratch) const;
  void go_up(const EigenstrainStress::Spectra& spectra, const Tile& tile, Scratch& scratch) const;
  void go_down(const EigenstrainStress::Spectra& spectra, const Tile& tile, const Scratch& scratch) const;
  [[nodiscard]] static Point travelled(const Coupling& over, const Point& wave);
  [[nodiscard]] Factors scaled(const Factors& unit, std::size_t part) const;
  [[nodiscard]] std::size_t wave_at(int block, int row) const
  {
    return static_cast<std::size_t>((block - blocks_.first) * (fft_.py() / 2 + 1) + row);
  }

  VolumeGrid grid_;
  const BlockedFft& fft_;
  Portion blocks_;
  std::vector<StackPart> parts_;
  std::vector<Stiffness> stiffness_;  ///< of the materials [Pa]
  std::size_t spectra_bytes_;         ///< of the stress at all wavenumbers
  AlignedVector<Factors> factors_;    ///< [own block][row] of a body of unit stiffness, only rows with ky >= 0
  AlignedVector<Matrix> surface_;     ///< [own block][row]
  AlignedVector<Coupling> couplings_; ///< [own block][row][material]
};

} // namespace brinell::halfspace
