// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nanobind/nanobind.h>

/// The extension brinell._core: names, defaults and docstrings for people are in the Python modules on top of it.
namespace brinell::python
{

void bind_app(nanobind::module_& m);
void bind_stepping(nanobind::module_& m);
void bind_reference(nanobind::module_& m);
void bind_green(nanobind::module_& m);
void bind_constitutive(nanobind::module_& m);
void bind_halfspace(nanobind::module_& m);
void bind_heat(nanobind::module_& m);
void bind_contact(nanobind::module_& m);
void bind_elastoplastic(nanobind::module_& m);
void bind_textures(nanobind::module_& m);
void bind_curves(nanobind::module_& m);

} // namespace brinell::python
