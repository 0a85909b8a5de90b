// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/foundation/error.hpp"
#include "contact_parts.hpp"
#include "foundation/require_size.hpp"

#include <algorithm>
#include <utility>

/// Construction of a coupled contact.
namespace brinell::elastoplastic
{

namespace
{

using halfspace::HalfSpace;

std::shared_ptr<const HalfSpace> operators(const VolumeGrid& grid, const constitutive::Material& material,
                                           const HalfSpace::Ranks& ranks)
{
  return material.elastic.is_rigid() ? nullptr : std::make_shared<const HalfSpace>(grid, material.stack(), ranks);
}

/// Of homogeneous bodies, the compliance depends on the contact modulus alone.
halfspace::SurfaceCompliance normal_compliance(const SurfaceGrid& contact, const constitutive::Material& lower,
                                               const constitutive::Material& upper, double reference)
{
  if (lower.layers.empty() && upper.layers.empty())
    return {contact, contact_modulus(lower.elastic, upper.elastic), reference};
  return {contact, lower.stack(), upper.stack(), reference};
}

std::unique_ptr<Interface> make_interface(const SurfaceGrid& contact, const constitutive::Material& lower,
                                          const constitutive::Material& upper, const Sliding& sliding, double reference)
{
  if (sliding.sticks && sliding.friction.coefficient > 0.0)
    return std::make_unique<PartialSlip>(contact, lower.stack(), upper.stack(), sliding.friction, reference);
  return std::make_unique<SlidingInterface>(contact, lower.stack(), upper.stack(), sliding.friction, sliding.direction,
                                            reference);
}

/// Displacements of the surfaces on which pressure and shear do work.
halfspace::Displacements displacements_under(const Interface* interface)
{
  if (interface == nullptr)
    return halfspace::Displacements::normal;
  return interface->shears()[1].empty() ? halfspace::Displacements::along_x : halfspace::Displacements::all;
}

} // namespace

const Communicator& ranks_of(const ContactParts& c)
{
  // A rigid body is not shared.
  const auto shares = [](const Side& side) { return !side.body.ranks().is_alone(); };
  const auto shared = std::find_if(c.sides.begin(), c.sides.end(), shares);
  return shared == c.sides.end() ? c.sides.front().body.ranks() : shared->body.ranks();
}

CoupledContact::CoupledContact(const SurfaceGrid& contact, const VolumeGrid& lower, const VolumeGrid& upper,
                               const constitutive::Material& lower_material,
                               const constitutive::Material& upper_material, const Scales& scales,
                               const Settings& settings, Twin twin, Textures textures, double reference,
                               const Sliding& sliding, const std::shared_ptr<const Communicator>& ranks,
                               const std::shared_ptr<const Device>& device)
    : parts_(make_hidden<ContactParts>(Between{}, normal_compliance(contact, lower_material, upper_material, reference),
                                       std::move(textures), scales, settings, twin)),
      between_(&*parts_)
{
  ContactParts& c = *parts_;
  for (std::vector<double>* field : {&c.state.pressure, &c.state.gap, &c.distance})
    field->assign(contact.size(), 0.0);
  for (const SurfaceGrid& s : {lower.surface, upper.surface})
    if (s.ny != contact.ny || s.dx != contact.dx || s.dy != contact.dy || s.boundary_x != contact.boundary_x ||
        s.boundary_y != contact.boundary_y || s.is_mirrored_y != contact.is_mirrored_y ||
        (contact.is_periodic_x() && s.nx != contact.nx))
      throw InternalError("CoupledContact: the three grids must have the same cells, rows and boundaries");
  if (sliding.sticks && contact.is_mirrored_y)
    throw InternalError("CoupledContact: surfaces that may stick are not solved by halves");
  const bool are_alike = lower == upper && lower_material.stack() == upper_material.stack();
  if (twin != Twin::none && !(are_alike && lower_material == upper_material))
    throw InternalError("CoupledContact: bodies that are not alike cannot be twins");
  for (const auto& [texture, grid] : {std::pair{&c.textures.lower, &lower}, {&c.textures.upper, &upper}})
    if (!texture->empty())
      require_size("CoupledContact: the texture", *texture, grid->surface.size());
  const bool has_friction = sliding.friction.coefficient > 0.0;
  if (has_friction && twin == Twin::alike)
    throw InternalError("CoupledContact: the shear acts on the bodies in opposite ways, so they are not alike");
  // Heat needs an interface, if need be without friction; with an interface pressure and effects are solved in turns.
  if (has_friction || sliding.heat || sliding.effects.need_turns())
    c.interface = make_interface(contact, lower_material, upper_material, sliding, reference);
  if (sliding.heat)
    c.heating = std::make_unique<Heating>(
        contact, std::array{Heating::Partner{lower, lower_material}, Heating::Partner{upper, upper_material}},
        *sliding.heat, twin, HeatNumerics{settings.shortcuts, c.may_stick()});
  if (twin != Twin::none && !sliding.effects.are_alike())
    throw InternalError("CoupledContact: bodies on which an effect acts in different ways are not twins");
  c.effects =
      make_effects(sliding.effects, c.compliance, lower, upper,
                   contact_modulus(lower_material.top(), upper_material.top()), {&lower_material, &upper_material});
  if (device && (lower_material.is_plastic() || upper_material.is_plastic()))
    c.contact.iterate_on(device->make_contact(contact, c.compliance.normal_spectra()));
  const auto half_space = operators(lower, lower_material, ranks);
  const BodySettings of_body{.shortcuts = settings.shortcuts,
                             .displacements = displacements_under(c.interface.get()),
                             .windows = settings.windows,
                             .device = device};
  if (twin != Twin::none && !(c.textures.lower_inclusions.empty() && c.textures.upper_inclusions.empty()))
    throw InternalError("CoupledContact: bodies with inclusions are not twins");
  if (ranks && !ranks->is_alone() && !(c.textures.lower_inclusions.empty() && c.textures.upper_inclusions.empty()))
    throw InputError("a body with inclusions is shared by ranks; allowed: one process");
  const auto with = [&](const std::vector<Inclusion>& inclusions)
  {
    BodySettings one = of_body;
    one.inclusions = inclusions;
    return one;
  };
  c.sides.push_back(
      {.body = Body(lower, half_space, lower_material, with(c.textures.lower_inclusions)), .place = &Placement::lower});
  if (twin == Twin::none)
    c.sides.push_back({.body = Body(upper, are_alike ? half_space : operators(upper, upper_material, ranks),
                                    upper_material, with(c.textures.upper_inclusions)),
                       .place = &Placement::upper,
                       .shear_sign = -1.0});
}

void CoupledContact::set_softening(std::span<const double> lower, std::span<const double> upper)
{
  ContactParts& c = *parts_;
  if (c.twin != Twin::none && !upper.empty())
    throw InternalError("CoupledContact: an upper body that is a twin has the softening of the lower one");
  c.sides.front().body.set_softening(lower);
  if (c.twin == Twin::none)
    c.sides.back().body.set_softening(upper);
}

} // namespace brinell::elastoplastic
