// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "boundary_parts.hpp"
#include "brinell/foundation/error.hpp"
#include "brinell/green/elastic.hpp"
#include "image_kernels.hpp"
#include "wave_kernels.hpp"

#include <array>
#include <span>
#include <vector>

namespace brinell::device
{

/// Plastic strain and tractions -> stress, and plastic strain -> displacement of the surface, of a homogeneous half space: the
/// operators of halfspace::HalfSpace, on an executor. Fields are pointers to memory of the executor; deviators are
/// [component][layer][row][column]. Mirror images on both sides of y = 0 are not made use of: all rows are read and written.
template <typename Executor>
class HalfSpace
{
public:
  template <typename Value>
  using Memory = typename Executor::template Memory<Value>;

  /// @param boundary  `boundary_of` this body
  HalfSpace(const VolumeGrid& grid, const Elastic& elastic, const BoundaryParts& boundary, const Executor& executor)
      : grid_{grid.surface.whole(), grid.nz, grid.dz}, elastic_(elastic),
        executor_(&executor), waves_{boundary.px, boundary.py, grid.surface.dx, grid.surface.dy},
        is_periodic_(grid.surface.is_periodic()), x_functions_(copied(boundary.x_functions)),
        y_functions_(copied(boundary.y_functions)), images_(boundary.images)
  {
    std::vector<Factors> factors;
    factors.reserve(waves_.stored());
    for (std::size_t wave = 0; wave < waves_.stored(); ++wave)
      factors.push_back(halfspace::layer_waves::factors_of(
          waves_.m(wave), waves_.n(wave), waves_.is_shortest_x(wave) ? 0.0 : 1.0,
          waves_.is_shortest_y(wave) ? 0.0 : 1.0, grid_.dz, elastic_.poisson_ratio, elastic_.shear_modulus()));
    factors_ = copied(factors);
    for (std::size_t t = 0; t < kernels_.size(); ++t)
      kernels_[t] = copied(boundary.kernels[t]);
  }

  /// Buffers of one evaluation; make one per concurrent caller, once.
  struct Work
  {
    typename Executor::Transform of_volume, of_surface;
    Memory<ComplexNumber> strain, stress;          ///< spectra
    std::array<Memory<ComplexNumber>, 3> traction; ///< spectra
    Memory<ComplexNumber> displacement;            ///< spectrum
    Memory<double> sums, moments, coefficients;    ///< of images
    std::vector<double> host_moments, host_coefficients;
    bool has_strain = false;

    explicit Work(const HalfSpace& of)
        : of_volume(
              of.executor_->transform(of.grid_.surface, of.waves_.px, of.waves_.py, static_cast<int>(of.planes()))),
          of_surface(of.executor_->transform(of.grid_.surface, of.waves_.px, of.waves_.py, 1)),
          strain(of.executor_->template allocate<ComplexNumber>(of.planes() * of.waves_.size())),
          stress(of.executor_->template allocate<ComplexNumber>(of.planes() * of.waves_.size())),
          displacement(of.executor_->template allocate<ComplexNumber>(of.waves_.size()))
    {
      for (Memory<ComplexNumber>& spectrum : traction)
        spectrum = of.executor_->template allocate<ComplexNumber>(of.waves_.size());
      if (!of.images_)
        return;
      const Planes functions = of.functions();
      const std::size_t count = of.planes() * functions.of_x * functions.of_y;
      sums = of.executor_->template allocate<double>(of.planes() * functions.of_y * functions.nx);
      moments = of.executor_->template allocate<double>(count);
      coefficients = of.executor_->template allocate<double>(count);
      host_moments.resize(count);
      host_coefficients.resize(count);
    }
  };
  [[nodiscard]] Work make_work() const { return Work(*this); }

  /// Transforms the plastic strain [-], and finds the stress of its images.
  /// @param plastic_strain  nullptr: none
  void load(const double* plastic_strain, Work& work) const
  {
    work.has_strain = plastic_strain != nullptr;
    if (!work.has_strain)
      return;
    work.of_volume.forward(plastic_strain, work.strain.data());
    if (images_)
      find_images(plastic_strain, work);
  }
  /// Displacement of the surface [m] by the strain that was loaded, along the direction of a traction.
  void displacement(Traction along, Work& work, double* out) const
  {
    const std::size_t cells = grid_.surface.size();
    if (!work.has_strain)
      return executor_->run("no displacement", cells, SetZero{out});
    executor_->run("displacement by plastic strain", waves_.size(),
                   DisplacementOfWave{{waves_, along, grid_.nz, grid_.dz, elastic_.poisson_ratio, table(along)},
                                      work.strain.data(),
                                      work.displacement.data()});
    work.of_surface.inverse(work.displacement.data(), out);
    executor_->run("scale of a displacement", cells, Scale{scale(), out});
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
                        {nullptr, nullptr, nullptr},
                        work.stress.data()};
    const std::array<const double*, 3> fields{load.pressure, load.shear_x, load.shear_y};
    for (std::size_t t = 0; t < fields.size(); ++t)
      if (fields[t] != nullptr)
      {
        work.of_surface.forward(fields[t], work.traction[t].data());
        kernel.traction[t] = work.traction[t].data();
        kernel.kernels[t] = table(static_cast<Traction>(t));
      }
    executor_->run("stress of a wave", waves_.size(), kernel);
    work.of_volume.inverse(work.stress.data(), deviator);
    executor_->run("local stress", grid_.size(),
                   FinishStress{halfspace::layer_waves::held_layer(elastic_.poisson_ratio, elastic_.shear_modulus()),
                                grid_.size(), scale(), work.has_strain ? plastic_strain : nullptr, deviator});
    if (work.has_strain && images_)
      executor_->run("stress of images", Deviator::size * grid_.size(),
                     SubtractFunctions{functions(), work.sums.data(), deviator});
  }

  [[nodiscard]] const VolumeGrid& grid() const { return grid_; }

private:
  using Factors = StressOfWave::Factors;

  template <typename Value>
  [[nodiscard]] Memory<Value> copied(const std::vector<Value>& values) const
  {
    Memory<Value> memory = executor_->template allocate<Value>(values.size());
    executor_->write(std::span<const Value>(values), memory);
    return memory;
  }
  [[nodiscard]] std::size_t planes() const
  {
    return static_cast<std::size_t>(Deviator::size) * static_cast<std::size_t>(grid_.nz);
  }
  [[nodiscard]] double scale() const { return 1.0 / (static_cast<double>(waves_.px) * waves_.py); }
  /// Table of kernels, or nullptr for those of waves.
  [[nodiscard]] const double* table(Traction traction) const
  {
    if (is_periodic_)
      return nullptr;
    const Memory<double>& of_traction = kernels_[static_cast<std::size_t>(traction)];
    if (of_traction.size() != static_cast<std::size_t>(grid_.nz * Deviator::size) * waves_.stored())
      throw InternalError("device::HalfSpace: the boundary has no kernels of this traction");
    return of_traction.data();
  }
  [[nodiscard]] Planes functions() const
  {
    const auto nx = static_cast<std::size_t>(grid_.surface.nx), ny = static_cast<std::size_t>(grid_.surface.ny);
    return {nx, ny, x_functions_.size() / nx, y_functions_.size() / ny, x_functions_.data(), y_functions_.data()};
  }
  /// The moments go to the processor, whose products of them are small, and the coefficients come back.
  void find_images(const double* plastic_strain, Work& work) const
  {
    executor_->run("sums over rows", work.sums.size(), SumOverRows{functions(), plastic_strain, work.sums.data()});
    executor_->run("sums over columns", work.moments.size(),
                   SumOverColumns{functions(), work.sums.data(), work.moments.data()});
    executor_->read(work.moments, std::span<double>(work.host_moments));
    images_(work.host_moments, work.host_coefficients);
    executor_->write(std::span<const double>(work.host_coefficients), work.coefficients);
    executor_->run("coefficients of columns", work.sums.size(),
                   CoefficientsOfColumn{functions(), work.coefficients.data(), work.sums.data()});
  }

  VolumeGrid grid_;
  Elastic elastic_;
  const Executor* executor_;
  SurfaceWaves waves_;
  bool is_periodic_;
  Memory<Factors> factors_;
  std::array<Memory<double>, 3> kernels_;
  Memory<double> x_functions_, y_functions_;
  decltype(BoundaryParts::images) images_; ///< empty without images
};

} // namespace brinell::device
