// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/halfspace/surface_compliance.hpp"

#include "brinell/foundation/error.hpp"
#include "foundation/lazy.hpp"
#include "foundation/require_size.hpp"
#include "halfspace/transform/cell_response.hpp"
#include "halfspace/transform/kernel_places.hpp"
#include "halfspace/transform/require_surface.hpp"
#include "halfspace/transform/wave_product.hpp"
#include "shear_stiffness.hpp"
#include "stack_shears.hpp"
#include "tractions.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

namespace brinell::halfspace
{

namespace
{

/// Spectrum for bodies that are periodic along both axes, row by row: 2 / (E' k), the displacement by a wave of unit pressure.
std::vector<double> wave_spectrum(const SurfaceGrid& grid, double contact_modulus)
{
  std::vector<double> spectrum;
  for (int row = 0; row <= grid.ny / 2; ++row)
    for (int i = 0; i <= grid.nx / 2; ++i)
    {
      const double k = 2.0 * std::numbers::pi * std::hypot(i / (grid.nx * grid.dx), row / (grid.ny * grid.dy));
      spectrum.push_back(k > 0.0 ? 2.0 / (contact_modulus * k) : 0.0);
    }
  return spectrum;
}

/// Reciprocals of a spectrum. A uniform pressure, whose compliance is zero, must be assigned a stiffness: restricted to a nearly
/// full contact, its compliance is that of the open spots, much less than that of any wave on the grid.
std::vector<double> inverse(std::vector<double> spectrum)
{
  // Of the values 1, 1/4, 1/16, 1/64 and 1/1000, this one needs the fewest iterations over all contact areas.
  constexpr double share = 1.0 / 64.0;
  const double uniform = share * *std::max_element(spectrum.begin(), spectrum.end());
  for (double& response : spectrum)
    response = 1.0 / (response > 0.0 ? response : uniform);
  return spectrum;
}

/// The layered ones of two bodies.
using Stacks = std::vector<LayeredBody>;

Stacks layered(const ElasticStack& body1, const ElasticStack& body2)
{
  Stacks stacks;
  for (const LayeredBody& body : {LayeredBody{body1, 1.0}, LayeredBody{body2, -1.0}})
    if (const ElasticStack merged = body.stack.merged(); !merged.is_homogeneous())
      stacks.push_back({merged, body.sign});
  return stacks;
}

/// The component of the compliance by which a layered body responds: along z by a pressure, or the potential of a current.
using Response = double green::WaveCompliance::*;

/// Adds what a wave of unit pressure displaces a layered body more than a body of its top material.
void add_excess(const SurfaceGrid& grid, const ElasticStack& stack, Response of, std::vector<double>& spectrum)
{
  auto value = spectrum.begin();
  for (int row = 0; row <= grid.ny / 2; ++row)
    for (int i = 0; i <= grid.nx / 2; ++i, ++value)
    {
      const double k = 2.0 * std::numbers::pi * std::hypot(i / (grid.nx * grid.dx), row / (grid.ny * grid.dy));
      if (k > 0.0)
        *value += green::StackWave(stack, k).compliance().*of - 2.0 * stack.top().contact_compliance() / k;
    }
}

/// Spectra of the operator and of its approximate inverse, row by row.
struct Spectra
{
  std::vector<double> compliance; ///< [m/Pa]
  std::vector<double> stiffness;  ///< [Pa/m]
};

Spectra spectra(const SurfaceGrid& grid, const SurfaceGrid& larger, double modulus, const Stacks& stacks, Response of,
                double reference)
{
  if (grid.is_periodic())
  {
    std::vector<double> waves = wave_spectrum(grid, modulus);
    for (const LayeredBody& body : stacks)
      add_excess(grid, body.stack, of, waves);
    return {waves, inverse(waves)};
  }
  Quadrant<double> response = cell_displacement(larger, reference);
  for (const LayeredBody& body : stacks)
  {
    const Quadrant<SurfaceExcess> excess = excess_surface(larger, body.stack, reference, of);
    for (std::size_t n = 0; n < response.values.size(); ++n)
      response.values[n] += std::numbers::pi * modulus * excess.values[n][excess::zz];
  }
  const auto displacement = [&](int i, int j) { return response.at(i, j) / (std::numbers::pi * modulus); };
  return {spectrum_of(grid, KernelPlaces::padded(grid), displacement),
          inverse(spectrum_of(larger, KernelPlaces::periodic(larger), displacement))};
}

} // namespace

namespace
{

/// A product with a real and even spectrum.
struct EvenProduct
{
  WaveProduct<1> waves;
  WaveTable<Lanes> factors;

  /// @param spectrum  row by row
  EvenProduct(const SurfaceGrid& grid, const PaddedLengths& lengths, const std::vector<double>& spectrum)
      : waves(grid, lengths), factors(waves.fft())
  {
    const double* factor = spectrum.data();
    for (int row = 0; row < factors.rows(); ++row)
      for (int i = 0; i < waves.fft().kx(); ++i, ++factor)
        factors.of_column(row, i)[i % lane_count] = *factor;
  }

  void apply(std::span<const double> in, std::span<double> out, WaveProduct<1>::Scratch& scratch) const
  {
    waves.apply({in}, {out}, scratch,
                [this](int block)
                {
                  return [factor = factors.of_block(block)](int row, const WaveProduct<1>::Values& values)
                  { return WaveProduct<1>::Values{factor[row] * values[0]}; };
                });
  }
};

/// Displacement by a pressure, and approximately the pressure that causes a displacement.
struct Normal
{
  EvenProduct compliance, stiffness;
  double largest; ///< [m/Pa]

  Normal(const SurfaceGrid& grid, double modulus, const Stacks& stacks, Response of, double reference)
      : Normal(grid, with_fast_lengths(grid), spectra(grid, with_fast_lengths(grid), modulus, stacks, of, reference))
  {
  }

private:
  Normal(const SurfaceGrid& grid, const SurfaceGrid& larger, const Spectra& of)
      : compliance(grid, padded_lengths(grid), of.compliance), stiffness(grid, {larger.nx, larger.ny}, of.stiffness),
        largest(*std::max_element(of.compliance.begin(), of.compliance.end()))
  {
  }
};

} // namespace

struct SurfaceCompliance::Buffers
{
  SurfaceGrid grid;
  std::optional<WaveProduct<1>::Scratch> compliance{}, stiffness{};
  std::optional<Tractions::Product::Scratch> tractions{};
  std::optional<ShearStiffness::Scratch> shear_stiffness{};
};

/// The parts are set up when they are first needed.
struct SurfaceCompliance::Operator
{
  SurfaceGrid grid;
  double modulus; ///< E' at the surfaces [Pa]
  std::optional<green::PairConstants> pair;
  double reference; ///< [m]
  Stacks stacks{};
  bool are_equal = false; ///< layered bodies
  Response response = &green::WaveCompliance::normal;
  Lazy<Normal> normal_part{};
  Lazy<Tractions> traction_part{};
  Lazy<ShearStiffness> shear_part{};

  [[nodiscard]] const Normal& normal() const
  {
    return normal_part.get([this] { return Normal(grid, modulus, stacks, response, reference); });
  }
  [[nodiscard]] const green::PairConstants& constants() const
  {
    if (!pair)
      throw InternalError("SurfaceCompliance: shears and displacements along the surface need the constants of both "
                          "bodies, not only their contact modulus");
    return *pair;
  }
  [[nodiscard]] const Tractions& tractions() const
  {
    return traction_part.get([this] { return Tractions(grid, constants(), reference, stacks); });
  }
  [[nodiscard]] const ShearStiffness& shear_stiffness() const
  {
    return shear_part.get([this] { return ShearStiffness(grid, constants(), reference, stacks); });
  }
};

SurfaceCompliance::SurfaceCompliance(Hidden<Operator> made) : operator_(std::move(made))
{
  const SurfaceGrid& grid = operator_->grid;
  if (grid.is_periodic_x() != grid.is_periodic_y() && !(operator_->reference > 0.0))
    throw InternalError("SurfaceCompliance: with one periodic axis the displacement needs a reference distance, > 0");
  if (grid.is_periodic() && grid.size() == 1)
    throw InputError("a surface grid of 1 x 1 cells that is periodic along both axes can only carry a uniform "
                     "pressure, which causes no displacement; allowed: more than one cell along x or y");
}

SurfaceCompliance::SurfaceCompliance(const SurfaceGrid& grid, double contact_modulus, double reference)
    : SurfaceCompliance(make_hidden<Operator>(grid, contact_modulus, std::nullopt, reference))
{
}

SurfaceCompliance::SurfaceCompliance(const SurfaceGrid& grid, const Elastic& body1, const Elastic& body2,
                                     double reference)
    : SurfaceCompliance(
          make_hidden<Operator>(grid, contact_modulus(body1, body2), green::pair_constants(body1, body2), reference))
{
}

SurfaceCompliance::SurfaceCompliance(const SurfaceGrid& grid, const ElasticStack& body1, const ElasticStack& body2,
                                     double reference)
    : SurfaceCompliance(make_hidden<Operator>(grid, contact_modulus(body1.top(), body2.top()),
                                              green::pair_constants(body1.top(), body2.top()), reference,
                                              layered(body1, body2), body1 == body2))
{
  for (const LayeredBody& body : operator_->stacks)
    require_resolved(grid, body.stack);
}

SurfaceCompliance SurfaceCompliance::of_conductors(const SurfaceGrid& grid, const ConductiveStack& body1,
                                                   const ConductiveStack& body2, double reference)
{
  const ElasticStack one = in_shear(body1), other = in_shear(body2);
  SurfaceCompliance result(make_hidden<Operator>(grid, contact_modulus(one.top(), other.top()), std::nullopt, reference,
                                                 layered(one, other), body1 == body2, &green::WaveCompliance::across));
  for (const LayeredBody& body : result.operator_->stacks)
    require_resolved(grid, body.stack);
  return result;
}

double SurfaceCompliance::reference() const
{
  return operator_->reference;
}

const SurfaceGrid& SurfaceCompliance::grid() const
{
  return operator_->grid;
}

SurfaceCompliance SurfaceCompliance::on(const SurfaceGrid& grid) const
{
  return SurfaceCompliance(make_hidden<Operator>(grid, operator_->modulus, operator_->pair, operator_->reference,
                                                 operator_->stacks, operator_->are_equal, operator_->response));
}

bool SurfaceCompliance::couples() const
{
  return operator_->constants().coupling != 0.0 || (!operator_->stacks.empty() && !operator_->are_equal);
}

double SurfaceCompliance::along_over_across() const
{
  return 1.0 + operator_->constants().along / operator_->constants().normal;
}

SurfaceCompliance::NormalSpectra SurfaceCompliance::normal_spectra() const
{
  const Operator& op = *operator_;
  const SurfaceGrid larger = with_fast_lengths(op.grid);
  const PaddedLengths lengths = padded_lengths(op.grid);
  Spectra of = spectra(op.grid, larger, op.modulus, op.stacks, op.response, op.reference);
  return {{lengths.x, lengths.y, std::move(of.compliance)}, {larger.nx, larger.ny, std::move(of.stiffness)}};
}

double SurfaceCompliance::largest() const
{
  return operator_->normal().largest;
}

double SurfaceCompliance::largest_of_shear() const
{
  return operator_->tractions().largest_of_shear();
}

double SurfaceCompliance::stiffness_of_cell() const
{
  return operator_->shear_stiffness().of_one_cell();
}

SurfaceCompliance::Scratch SurfaceCompliance::make_scratch() const
{
  return make_hidden<Buffers>(grid());
}

namespace
{

/// The buffers of a part, made when they are first needed.
template <typename Buffer, typename Part>
Buffer& buffers_of(std::optional<Buffer>& buffer, const Part& part)
{
  if (!buffer)
    buffer.emplace(part.make_scratch());
  return *buffer;
}

} // namespace

/// @throws InternalError if a scratch is that of another grid
void SurfaceCompliance::require_own(const char* function_name, const Scratch& scratch) const
{
  if (scratch.empty() || !(scratch->grid == grid()))
    throw InternalError(fmt::format("{}: the scratch is of another operator; make_scratch makes one", function_name));
}

void SurfaceCompliance::apply(const SurfaceLoad& load, const SurfaceDisplacement& displacement, Scratch& scratch) const
{
  require_load("SurfaceCompliance::apply", load, grid().size());
  require_displacement("SurfaceCompliance::apply", displacement, grid().size());
  require_own("SurfaceCompliance::apply", scratch);
  const bool is_normal =
      load.shear_x.empty() && load.shear_y.empty() && displacement.x.empty() && displacement.y.empty();
  if (!is_normal)
  {
    const Tractions& tractions = operator_->tractions();
    tractions.apply(load, displacement, buffers_of(scratch->tractions, tractions));
  }
  else if (load.pressure.empty())
    std::fill(displacement.z.begin(), displacement.z.end(), 0.0);
  else
  {
    const EvenProduct& compliance = operator_->normal().compliance;
    compliance.apply(load.pressure, displacement.z, buffers_of(scratch->compliance, compliance.waves));
  }
}

void SurfaceCompliance::apply(const SurfaceLoad& load, const SurfaceDisplacement& displacement) const
{
  Scratch scratch = make_scratch();
  apply(load, displacement, scratch);
}

void SurfaceCompliance::apply_inverse(std::span<const double> displacement, std::span<double> pressure,
                                      Scratch& scratch) const
{
  require_size("SurfaceCompliance::apply_inverse: the displacement", displacement, grid().size());
  require_size("SurfaceCompliance::apply_inverse: the pressure", pressure, grid().size());
  require_own("SurfaceCompliance::apply_inverse", scratch);
  const EvenProduct& stiffness = operator_->normal().stiffness;
  stiffness.apply(displacement, pressure, buffers_of(scratch->stiffness, stiffness.waves));
}

void SurfaceCompliance::apply_inverse(const Pair<std::span<const double>>& displacement,
                                      const Pair<std::span<double>>& shear, Scratch& scratch, double added) const
{
  for (std::size_t axis = 0; axis < 2; ++axis)
  {
    require_size("SurfaceCompliance::apply_inverse: the displacement", displacement[axis], grid().size());
    require_size("SurfaceCompliance::apply_inverse: the shear", shear[axis], grid().size());
  }
  require_own("SurfaceCompliance::apply_inverse", scratch);
  const ShearStiffness& stiffness = operator_->shear_stiffness();
  stiffness.apply(displacement, shear, buffers_of(scratch->shear_stiffness, stiffness), added);
}

} // namespace brinell::halfspace
