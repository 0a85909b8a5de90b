// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/elastoplastic/anderson.hpp"
#include "brinell/foundation/archive.hpp"
#include "brinell/halfspace/inclusions.hpp"

#include <array>
#include <span>
#include <vector>

namespace brinell::elastoplastic
{

/// Inclusions of a body in an increment: their equivalent strain for the stress of each trial, and what it adds to stress and
/// displacement. The contact of an evaluation needs the displacement before the stress, and so the equivalent strain, is known: it takes that which the
/// evaluations before suggest (Anderson acceleration). Where an increment has converged, it is that of the equivalent strain, to `error`.
class Embedded
{
public:
  /// @param axes  of the displacement that are needed: z, then x, then y
  Embedded(const halfspace::HalfSpace& body, const std::vector<halfspace::Inclusion>& inclusions, std::size_t axes);

  [[nodiscard]] int layers() const { return inclusions_.layers(); }
  /// Stress of the own strain of the inclusions, with their equivalent strain for it, without load and plastic strain: [Pa]. Empty without own
  /// strain. It is an initial stress: the surface is flat with it.
  [[nodiscard]] const std::vector<double>& own_deviator() const { return own_deviator_; }
  [[nodiscard]] const std::vector<double>& own_trace() const { return own_trace_; }
  /// Adds the displacement along z (0), x (1) or y (2).
  void add_displacement(std::size_t axis, std::span<double> displacement) const;
  /// Finds the equivalent strain under a load, and adds its stress to `stress`, that of load and plastic strain, in the layers [0, layers), and that of the own strain.
  /// @param strain  plastic strain, loaded with its trace
  /// @throws ConvergenceError
  void update(const halfspace::HalfSpace::Loaded& strain, const halfspace::SurfaceLoad& load, int layers,
              std::span<double> stress);
  /// Adds the stress of the present equivalent strain and of the own strain.
  void add_stress(int layers, std::span<double> deviator, std::span<double> trace);
  /// Iterations and residual of the last `update`.
  [[nodiscard]] const halfspace::Inclusions::Report& report() const { return report_; }
  /// Largest difference between the normal displacement that the last `update` has found and that before it [m].
  [[nodiscard]] double error() const { return error_; }
  void restore();
  void commit();
  void exchange(Archive& archive);

private:
  halfspace::Inclusions inclusions_;
  struct State
  {
    halfspace::Inclusions::Solution solution;
    std::vector<double> displacement; ///< [axis][cell] [m]
  };
  State present_, committed_;
  halfspace::InclusionField given_;
  std::size_t surface_, axes_;
  Anderson acceleration_;
  double error_ = 0.0;
  halfspace::Inclusions::Report report_{};
  std::vector<double> trace_, found_, change_, own_deviator_, own_trace_;

  void solve(halfspace::Inclusions::Solution& solution, int layers, const halfspace::HalfSpace::Dilated& to);
  void find_own_stress();
};

} // namespace brinell::elastoplastic
