// SPDX-License-Identifier: BSD-3-Clause
#include "dilatation_stress.hpp"
#include "foundation/require_size.hpp"
#include "half_space_operators.hpp"
#include "halfspace/transform/require_surface.hpp"

#include <fmt/format.h>

/// The dilatation of a half space: HalfSpace::add_dilatation.
namespace brinell::halfspace
{

struct HalfSpace::DilatationWork::Buffers
{
  DilatationStress::Work work;
};

HalfSpace::DilatationWork::DilatationWork() = default;
HalfSpace::DilatationWork::~DilatationWork() = default;
HalfSpace::DilatationWork::DilatationWork(DilatationWork&&) noexcept = default;
HalfSpace::DilatationWork& HalfSpace::DilatationWork::operator=(DilatationWork&&) noexcept = default;

const DilatationStress& HalfSpace::Operators::dilatation_stress() const
{
  return dilatation_.get([&] { return DilatationStress(grid, stack.substrate, surface_fft, shortest_waves); });
}

HalfSpace::DilatationWork HalfSpace::make_dilatation_work() const
{
  if (!stack().is_homogeneous())
    throw InputError("a dilatation in a body with layers of other elastic constants; allowed: a homogeneous body");
  operators_->require_alone("HalfSpace::make_dilatation_work");
  DilatationWork work;
  work.buffers_ =
      std::make_unique<DilatationWork::Buffers>(DilatationWork::Buffers{operators_->dilatation_stress().make_work()});
  return work;
}

void HalfSpace::add_dilatation(std::span<const double> dilatation, int layers, DilatationWork& work,
                               const Dilated& to) const
{
  const Operators& op = *operators_;
  const std::size_t cells = op.grid.size(), of_surface = op.grid.surface.size();
  require_size("HalfSpace::add_dilatation: the dilatation", dilatation, cells);
  if (!to.deviator.empty())
    require_size("HalfSpace::add_dilatation: the deviator", to.deviator, Deviator::size * cells);
  if (!to.trace.empty())
    require_size("HalfSpace::add_dilatation: the trace", to.trace, cells);
  if (layers < 0 || layers > op.grid.nz)
    throw InternalError(
        fmt::format("HalfSpace::add_dilatation: {} layers are wanted, the grid has {}", layers, op.grid.nz));
  if (!work.buffers_)
    throw InternalError("HalfSpace::add_dilatation: the work is empty; make_dilatation_work makes one");
  const OfTraction<std::span<double>> displacement{to.displacement.z, to.displacement.x, to.displacement.y};
  OfTraction<bool> wanted{};
  for (const Traction traction : tractions)
  {
    wanted[index(traction)] = !displacement[index(traction)].empty();
    if (wanted[index(traction)])
      require_size("HalfSpace::add_dilatation: the displacement", displacement[index(traction)], of_surface);
  }
  op.dilatation_stress().add(dilatation, layers, op.kernels_of(wanted), to.deviator, to.trace, displacement,
                             work.buffers_->work);
  for (const Traction traction : tractions)
    if (wanted[index(traction)])
      op.complete(traction == Traction::shear_y, displacement[index(traction)]);
}

} // namespace brinell::halfspace
