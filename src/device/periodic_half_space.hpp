// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/error.hpp"
#include "brinell/green/elastic.hpp"
#include "wave_kernels.hpp"

#include <array>
#include <span>
#include <vector>

namespace brinell::device
{

/// Plastic strain and tractions -> stress, and plastic strain -> displacement of the surface, of a homogeneous half space that is
/// periodic in x and y: the operators of halfspace::HalfSpace, on an executor. Fields are pointers to memory of the executor; deviators
/// are [component][layer][row][column]. Mirror images on both sides of y = 0 are not made use of: all rows are read and written.
template <typename Executor>
class PeriodicHalfSpace
{
public:
  template <typename Value>
  using Memory = typename Executor::template Memory<Value>;

  /// @throws InternalError unless the grid is periodic along both axes
  PeriodicHalfSpace(const VolumeGrid& grid, const Elastic& elastic, const Executor& executor)
      : grid_(periodic(grid)), elastic_(elastic), executor_(&executor), waves_(grid_.surface),
        factors_(executor.template allocate<Factors>(waves_.stored()))
  {
    std::vector<Factors> factors;
    factors.reserve(waves_.stored());
    for (std::size_t wave = 0; wave < waves_.stored(); ++wave)
      factors.push_back(halfspace::layer_waves::factors_of(
          waves_.m(wave), waves_.n(wave), waves_.is_shortest_x(wave) ? 0.0 : 1.0,
          waves_.is_shortest_y(wave) ? 0.0 : 1.0, grid_.dz, elastic_.poisson_ratio, elastic_.shear_modulus()));
    executor.write(std::span<const Factors>(factors), factors_);
  }

  /// Buffers of one evaluation; make one per concurrent caller, once.
  class Work
  {
    friend class PeriodicHalfSpace;
    typename Executor::Transform of_volume, of_surface;
    Memory<ComplexNumber> strain, stress;          ///< spectra
    std::array<Memory<ComplexNumber>, 3> traction; ///< spectra
    Memory<ComplexNumber> displacement;            ///< spectrum
    bool has_strain = false;

    Work(const VolumeGrid& grid, const SurfaceWaves& waves, const Executor& executor)
        : of_volume(executor.transform(grid.surface, Deviator::size * grid.nz)),
          of_surface(executor.transform(grid.surface, 1)),
          strain(executor.template allocate<ComplexNumber>(planes(grid) * waves.size())),
          stress(executor.template allocate<ComplexNumber>(planes(grid) * waves.size())),
          displacement(executor.template allocate<ComplexNumber>(waves.size()))
    {
      for (Memory<ComplexNumber>& spectrum : traction)
        spectrum = executor.template allocate<ComplexNumber>(waves.size());
    }
  };
  [[nodiscard]] Work make_work() const { return {grid_, waves_, *executor_}; }

  /// Transforms the plastic strain [-].
  /// @param plastic_strain  nullptr: none
  void load(const double* plastic_strain, Work& work) const
  {
    work.has_strain = plastic_strain != nullptr;
    if (work.has_strain)
      work.of_volume.forward(plastic_strain, work.strain.data());
  }
  /// Displacement of the surface [m] by the strain that was loaded, along the direction of a traction.
  void displacement(Traction along, Work& work, double* out) const
  {
    const std::size_t cells = grid_.surface.size();
    if (!work.has_strain)
      return executor_->run("no displacement", cells, Scale{0.0, out});
    executor_->run("displacement by plastic strain", waves_.size(),
                   DisplacementOfWave{waves_, grid_.nz, grid_.dz, elastic_.poisson_ratio, along, work.strain.data(),
                                      work.displacement.data()});
    work.of_surface.inverse(work.displacement.data(), out);
    executor_->run("scale of a displacement", cells, Scale{1.0 / static_cast<double>(cells), out});
  }

  /// Traction on the surface [Pa]; nullptr: none.
  struct Load
  {
    const double *pressure = nullptr, *shear_x = nullptr, *shear_y = nullptr;
  };
  /// Deviatoric stress [Pa] of the load and of the strain that was loaded.
  void stress(const Load& load, const double* plastic_strain, Work& work, double* deviator) const
  {
    StressOfWave kernel{waves_,
                        grid_.nz,
                        grid_.dz,
                        elastic_.poisson_ratio,
                        factors_.data(),
                        work.has_strain ? work.strain.data() : nullptr,
                        {nullptr, nullptr, nullptr},
                        work.stress.data()};
    const std::array<const double*, 3> fields{load.pressure, load.shear_x, load.shear_y};
    for (std::size_t t = 0; t < fields.size(); ++t)
      if (fields[t] != nullptr)
      {
        work.of_surface.forward(fields[t], work.traction[t].data());
        kernel.traction[t] = work.traction[t].data();
      }
    executor_->run("stress of a wave", waves_.size(), kernel);
    work.of_volume.inverse(work.stress.data(), deviator);
    executor_->run("local stress", grid_.size(),
                   FinishStress{halfspace::layer_waves::held_layer(elastic_.poisson_ratio, elastic_.shear_modulus()),
                                grid_.size(), 1.0 / static_cast<double>(grid_.surface.size()),
                                work.has_strain ? plastic_strain : nullptr, deviator});
  }

  [[nodiscard]] const VolumeGrid& grid() const { return grid_; }

private:
  using Factors = StressOfWave::Factors;

  static VolumeGrid periodic(VolumeGrid grid)
  {
    if (!grid.surface.is_periodic())
      throw InternalError("PeriodicHalfSpace: the grid is not periodic along both axes");
    grid.surface = grid.surface.whole();
    return grid;
  }
  static std::size_t planes(const VolumeGrid& grid)
  {
    return static_cast<std::size_t>(Deviator::size) * static_cast<std::size_t>(grid.nz);
  }

  VolumeGrid grid_;
  Elastic elastic_;
  const Executor* executor_;
  SurfaceWaves waves_;
  Memory<Factors> factors_;
};

} // namespace brinell::device
