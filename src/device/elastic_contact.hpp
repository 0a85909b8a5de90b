// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/contact/elastic_contact.hpp"
#include "brinell/foundation/error.hpp"
#include "brinell/halfspace/surface_compliance.hpp"
#include "contact/cell_terms.hpp"
#include "sums.hpp"
#include "wave_kernels.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <span>
#include <vector>

namespace brinell::device
{

/// Multiplies a wave by a real and even factor.
struct MultiplyWave
{
  SurfaceWaves waves;
  double scale;
  const double* factors; ///< of the `stored` waves
  ComplexNumber* spectrum;

  BRINELL_HOST_DEVICE void operator()(std::size_t wave) const
  {
    spectrum[wave] = scale * factors[waves.folded(wave)] * spectrum[wave];
  }
};

/// Product of surface fields with a spectrum of halfspace::SurfaceCompliance on an executor.
template <typename Executor>
class SurfaceProduct
{
public:
  SurfaceProduct(const SurfaceGrid& grid, const halfspace::SurfaceCompliance::Spectrum& spectrum,
                 const Executor& executor)
      : executor_(&executor), waves_{spectrum.px, spectrum.py, grid.dx, grid.dy},
        transform_(executor.transform(grid, spectrum.px, spectrum.py, 1)),
        factors_(executor.template allocate<double>(waves_.stored())),
        spectrum_(executor.template allocate<ComplexNumber>(waves_.size()))
  {
    if (spectrum.factors.size() != waves_.stored())
      throw InternalError("device::SurfaceProduct: the spectrum is not one of these lengths");
    executor.write(std::span<const double>(spectrum.factors), factors_);
  }
  /// Both fields may be the same.
  void apply(const double* in, double* out)
  {
    transform_.forward(in, spectrum_.data());
    executor_->run(
        "product with a spectrum", waves_.size(),
        MultiplyWave{waves_, 1.0 / (static_cast<double>(waves_.px) * waves_.py), factors_.data(), spectrum_.data()});
    transform_.inverse(spectrum_.data(), out);
  }

private:
  const Executor* executor_;
  SurfaceWaves waves_;
  typename Executor::Transform transform_;
  typename Executor::template Memory<double> factors_;
  typename Executor::template Memory<ComplexNumber> spectrum_;
};

/// Fields of the iteration of the elastic contact, in memory of an executor.
struct ContactFields
{
  double *pressure, *gap, *displacement, *direction, *image;
  const double* distance;
};

struct PressedTerm
{
  ContactFields f;
  BRINELL_HOST_DEVICE contact::PressedSum operator()(std::size_t n) const
  {
    return contact::pressed_term(f.pressure[n], f.displacement[n], f.distance[n]);
  }
};

/// Sets the gap of a cell; the sum is that of the errors.
struct GapOfCell
{
  ContactFields f;
  double approach;
  BRINELL_HOST_DEVICE contact::Errors operator()(std::size_t n) const
  {
    f.gap[n] = f.displacement[n] + f.distance[n] - approach;
    return contact::error_term(f.pressure[n], f.gap[n]);
  }
};

/// Sets the image to the gap in the free cells.
struct FreeGap
{
  ContactFields f;
  BRINELL_HOST_DEVICE void operator()(std::size_t n) const
  {
    f.image[n] = contact::is_free(f.pressure[n], f.gap[n]) ? f.gap[n] : 0.0;
  }
};

struct SlopeTerm
{
  ContactFields f;
  BRINELL_HOST_DEVICE contact::Slopes operator()(std::size_t n) const
  {
    return contact::slope_term(f.pressure[n], f.gap[n], f.image[n], f.direction[n]);
  }
};

/// Sets the next direction; the image is the preconditioned gap.
struct NextDirection
{
  ContactFields f;
  double beta, mean;
  BRINELL_HOST_DEVICE void operator()(std::size_t n) const
  {
    f.direction[n] = contact::is_free(f.pressure[n], f.gap[n]) ? f.image[n] + beta * f.direction[n] - mean : 0.0;
  }
};

struct CurvatureTerm
{
  ContactFields f;
  BRINELL_HOST_DEVICE double operator()(std::size_t n) const { return f.direction[n] * f.image[n]; }
};

/// Takes the step in a cell.
struct StepOfCell
{
  ContactFields f;
  double step;
  BRINELL_HOST_DEVICE contact::StepSums operator()(std::size_t n) const
  {
    const double moved = contact::moved_pressure(f.pressure[n], f.gap[n], step, f.direction[n]);
    f.pressure[n] = moved > 0.0 ? moved : 0.0;
    f.displacement[n] -= step * f.image[n];
    return {moved < 0.0 ? 1.0 : 0.0, f.pressure[n]};
  }
};

/// Scales pressure and displacement of a cell.
struct ScaleLoad
{
  ContactFields f;
  double factor;
  BRINELL_HOST_DEVICE void operator()(std::size_t n) const
  {
    f.pressure[n] *= factor;
    f.displacement[n] *= factor;
  }
};

/// Frictionless contact on an executor: the iteration of contact::ElasticContact, without its guess on larger cells, without a layer
/// between the surfaces and without use of mirror images.
template <typename Executor>
class ElasticContact
{
public:
  ElasticContact(const SurfaceGrid& grid, const halfspace::SurfaceCompliance::NormalSpectra& spectra,
                 const Executor& executor)
      : grid_(grid.whole()), executor_(&executor), compliance_(grid_, spectra.compliance, executor),
        stiffness_(grid_, spectra.stiffness, executor),
        largest_(*std::max_element(spectra.compliance.factors.begin(), spectra.compliance.factors.end())),
        pressure_(field()), gap_(field()), displacement_(field()), direction_(field()), image_(field()),
        distance_(field()), of_pressed_(cells(), executor), of_errors_(cells(), executor),
        of_slopes_(cells(), executor), of_steps_(cells(), executor), of_products_(cells(), executor)
  {
  }

  /// Arguments and result as those of contact::ElasticContact::solve, in memory of the processor.
  /// @throws InternalError for a mean gap, and for fields of another size
  [[nodiscard]] contact::Report solve(std::span<const double> distance, const contact::Drive& drive, double tolerance,
                                      int max_iterations, std::span<double> pressure, std::span<double> gap,
                                      const std::function<bool()>& wants_stop = {})
  {
    if (drive.kind == contact::Drive::Kind::mean_gap ||
        (drive.kind == contact::Drive::Kind::load && !(drive.value > 0.0)))
      throw InternalError("device::ElasticContact: solves for an approach or a load > 0");
    if (distance.size() != cells() || pressure.size() != cells() || gap.size() != cells())
      throw InternalError("device::ElasticContact: the fields are not of this grid");
    executor_->write(distance, distance_);
    start(distance, drive, pressure);
    executor_->run("no direction", cells(), SetZero{direction_.data()});
    const contact::Report report = iterate({distance, drive, tolerance, max_iterations, wants_stop}, pressure);
    executor_->read(pressure_, pressure);
    executor_->read(gap_, gap);
    return report;
  }

private:
  using Array = typename Executor::template Memory<double>;

  [[nodiscard]] std::size_t cells() const { return grid_.size(); }
  [[nodiscard]] Array field() const { return executor_->template allocate<double>(grid_.size()); }
  [[nodiscard]] ContactFields fields()
  {
    return {pressure_.data(), gap_.data(), displacement_.data(), direction_.data(), image_.data(), distance_.data()};
  }

  /// As contact::ElasticContact: the guess if it is not zero, otherwise the overlap over the largest compliance, or a pressure on the cell
  /// that touches first.
  void start(std::span<const double> distance, const contact::Drive& drive, std::span<double> pressure)
  {
    const bool load_given = drive.kind == contact::Drive::Kind::load;
    for (double& p : pressure)
      p = std::max(p, 0.0);
    const auto total = [&] { return std::accumulate(pressure.begin(), pressure.end(), 0.0); };
    if (!(total() > 0.0) && load_given)
      pressure[static_cast<std::size_t>(std::min_element(distance.begin(), distance.end()) - distance.begin())] = 1.0;
    else if (!(total() > 0.0))
      for (std::size_t n = 0; n < pressure.size(); ++n)
        pressure[n] = std::max(0.0, drive.value - distance[n]) / largest_;
    if (load_given)
      for (const double factor = drive.value / (total() * grid_.cell_area()); double& p : pressure)
        p *= factor;
    executor_->write(std::span<const double>(pressure), pressure_);
  }

  [[nodiscard]] contact::Report evaluate(const contact::Drive& drive)
  {
    contact::Report report;
    report.approach = drive.kind == contact::Drive::Kind::load
                          ? of_pressed_("mean over the pressed cells", cells(), PressedTerm{fields()}).mean()
                          : drive.value;
    const contact::Errors errors = of_errors_("gap", cells(), GapOfCell{fields(), report.approach});
    report.gap_error = errors.gap;
    report.penetration = errors.penetration;
    return report;
  }

  /// Sets the next direction and its image. @returns the step along it
  [[nodiscard]] double descend(double& slope, bool load_given)
  {
    executor_->run("free gap", cells(), FreeGap{fields()});
    stiffness_.apply(image_.data(), image_.data());
    const contact::Slopes slopes = of_slopes_("slopes", cells(), SlopeTerm{fields()});
    const contact::Descent descent = contact::descent_of(slopes, slope, load_given);
    executor_->run("direction", cells(), NextDirection{fields(), descent.beta, descent.mean});
    compliance_.apply(direction_.data(), image_.data());
    const double curvature = of_products_("curvature", cells(), CurvatureTerm{fields()});
    slope = descent.slope;
    return curvature > 0.0 ? descent.along / curvature : 0.0;
  }

  struct Problem
  {
    std::span<const double> distance;
    const contact::Drive& drive;
    double tolerance;
    int max_iterations;
    const std::function<bool()>& wants_stop;
  };
  [[nodiscard]] contact::Report iterate(const Problem& problem, std::span<double> pressure)
  {
    const auto& [distance, drive, tolerance, max_iterations, wants_stop] = problem;
    const bool load_given = drive.kind == contact::Drive::Kind::load;
    const auto is_good = [most = tolerance](const contact::Report& r)
    { return r.gap_error <= most && r.penetration <= most && std::isfinite(r.approach); };
    constexpr int many = 32, few = 8; // as in contact::ElasticContact
    int followed = many, products = 0;
    double slope = 0.0;
    for (int iteration = 0;; ++iteration)
    {
      if (wants_stop && iteration % few == 0 && wants_stop())
        throw Interrupted();
      const bool is_last = iteration == max_iterations;
      bool is_exact = followed >= many || is_last;
      contact::Report report;
      if (!is_exact)
      {
        report = evaluate(drive);
        is_exact = is_good(report);
      }
      if (is_exact)
      {
        compliance_.apply(pressure_.data(), displacement_.data());
        followed = 0;
        ++products;
        report = evaluate(drive);
      }
      report.iterations = iteration;
      report.products = products;
      report.converged = is_good(report);
      if (report.converged || is_last)
        return report;
      ++products;
      const double step = descend(slope, load_given);
      const contact::StepSums done = of_steps_("step", cells(), StepOfCell{fields(), step});
      followed = done.cut > 0.0 ? many : followed + 1;
      if (load_given && done.pressure > 0.0)
        executor_->run("load", cells(), ScaleLoad{fields(), drive.value / (done.pressure * grid_.cell_area())});
      else if (load_given) // all pressures were cut off: restart
      {
        std::fill(pressure.begin(), pressure.end(), 0.0);
        start(distance, drive, pressure);
        slope = 0.0;
      }
    }
  }

  SurfaceGrid grid_;
  const Executor* executor_;
  SurfaceProduct<Executor> compliance_, stiffness_;
  double largest_; ///< displacement by a wave of unit pressure [m/Pa]
  Array pressure_, gap_, displacement_, direction_, image_, distance_;
  Sums<Executor, contact::PressedSum> of_pressed_;
  Sums<Executor, contact::Errors> of_errors_;
  Sums<Executor, contact::Slopes> of_slopes_;
  Sums<Executor, contact::StepSums> of_steps_;
  Sums<Executor, double> of_products_;
};

/// The contact as a part of a run.
template <typename Executor>
class ContactOnExecutor : public contact::ContactOnDevice
{
public:
  ContactOnExecutor(const SurfaceGrid& grid, const halfspace::SurfaceCompliance::NormalSpectra& spectra,
                    const Executor& executor)
      : contact_(grid, spectra, executor)
  {
  }
  [[nodiscard]] contact::Report solve(std::span<const double> distance, const contact::Drive& drive, double tolerance,
                                      int max_iterations, std::span<double> pressure, std::span<double> gap,
                                      const std::function<bool()>& wants_stop) override
  {
    return contact_.solve(distance, drive, tolerance, max_iterations, pressure, gap, wants_stop);
  }

private:
  ElasticContact<Executor> contact_;
};

} // namespace brinell::device
