# SPDX-License-Identifier: BSD-3-Clause
"""First yield of contacts: its position with and without friction, and load and approach without friction."""

from __future__ import annotations

from dataclasses import dataclass

from brinell import _core
from brinell._arrays import numbers, require_poisson, require_positive
from brinell.errors import InputError
from brinell.reference.hertz import approach_origin


@dataclass(frozen=True)
class FirstYield:
    """Point of first yield of a contact, in the plane y = 0.

    Attributes:
        pressure_ratio: C = p0/S_y = p0/(largest von Mises stress) [-].
        depth_ratio: depth over contact radius, or over the half-width of a line contact [-].
        x_ratio: x over contact radius or half-width [-]; 0 without friction, -1 is the trailing edge of a slider that
            moves towards +x.
    """

    pressure_ratio: float
    depth_ratio: float
    x_ratio: float


def first_yield(poisson_ratio: float, friction: float = 0.0) -> FirstYield:
    """First yield (von Mises) of a point contact, exact.

    Without friction it is on the axis, or below nu = -0.31 at the edge of the contact.
    With friction by Hamilton (1983).

    Args:
        poisson_ratio: nu, in (-1, 0.5] [-].
        friction: shear on the body towards +x over the pressure, >= 0 [-]. From about 0.3 on, the surface yields first.

    Raises:
        InputError: a value is out of range.
    """
    return FirstYield(*_core.first_yield(*numbers(poisson_ratio=poisson_ratio, friction=friction)))


def line_contact_first_yield(poisson_ratio: float, friction: float = 0.0) -> FirstYield:
    """First yield (von Mises) of a line contact in plane strain, exact.

    Without friction the point is on the axis, up to nu = 0.1938 at the surface. The fits of Green (2005) agree within
    0.15 %.

    Args:
        poisson_ratio: nu, in (-1, 0.5] [-].
        friction: shear on the body towards +x over the pressure, >= 0 [-].

    Raises:
        InputError: a value is out of range.
    """
    return FirstYield(*_core.line_contact_first_yield(*numbers(poisson_ratio=poisson_ratio, friction=friction)))


def critical_pressure_ratio(poisson_ratio: float) -> float:
    """C(nu) = 1.30075 + 0.87825 nu + 0.54373 nu^2, a fit of p0/S_y at first yield (Green 2005), within 0.15 %.

    Below nu = 0, where the fit does not hold, the exact value: on the axis, or from nu = -0.31 down at the edge of the
    contact.
    """
    require_poisson(poisson_ratio)
    return _core.critical_pressure_ratio(poisson_ratio)


@dataclass(frozen=True)
class CriticalValues:
    """Values at first yield of a frictionless point or line contact.

    Attributes:
        C: peak pressure over yield stress, p0/S_y [-].
        interference: critical interference alpha_c [m].
        load: critical load P_c [N].
        energy: elastic energy U_c [J].
        contact_radius: contact radius a_c; for a line contact the half-width [m].
        contact_area: pi a_c^2; for a line contact of length L, 2 a_c L [m²].
        peak_pressure: C S_y [Pa].
    """

    C: float
    interference: float
    load: float
    energy: float
    contact_radius: float
    contact_area: float
    peak_pressure: float


def critical_values(
    radius: float,
    contact_modulus: float,
    yield_stress: float,
    *,
    poisson_ratio: float | None = None,
    C: float | None = None,
) -> CriticalValues:
    """Critical values of a sphere (Green 2005; Boucly, Nelias, Green 2006, Eqs. 24-27).

    Args:
        radius: R [m].
        contact_modulus: E' [Pa].
        yield_stress: S_y of the body that yields first, which is the one with the smaller C S_y [Pa].
        poisson_ratio: nu of that body, from which `critical_pressure_ratio` gives C [-].
        C: p0/S_y at first yield, instead of nu [-].

    Raises:
        InputError: a value is out of range, or not exactly one of poisson_ratio and C is given.
    """
    require_positive(radius=radius, contact_modulus=contact_modulus, yield_stress=yield_stress)
    if poisson_ratio is not None and C is None:
        C = critical_pressure_ratio(poisson_ratio)
    elif C is None or poisson_ratio is not None:
        raise InputError("critical_values needs either poisson_ratio or C")
    values = numbers(radius=radius, contact_modulus=contact_modulus, C=C, yield_stress=yield_stress)
    return CriticalValues(*_core.critical_values(*values))


def critical_line_values(
    radius: float,
    contact_modulus: float,
    yield_stress: float,
    *,
    poisson_ratio: float | None = None,
    C: float | None = None,
    length: float = 1.0,
    reference: float | None = None,
) -> CriticalValues:
    """Critical values of cylinders in plane strain (Green 2005).

    Args:
        radius: R [m].
        contact_modulus: E' [Pa].
        yield_stress: S_y of the body that yields first, which is the one with the smaller C S_y [Pa].
        poisson_ratio: nu of that body, from which `line_contact_first_yield` gives C [-].
        C: p0/S_y at first yield, instead of nu [-].
        length: length of the contact, to which load, energy and area refer [m].
        reference: reference distance l of the approach [m]; None: 2 R/e, as in Green's formulae.

    Raises:
        InputError: a value is out of range, or not exactly one of poisson_ratio and C is given.
    """
    require_positive(radius=radius, contact_modulus=contact_modulus, yield_stress=yield_stress)
    if poisson_ratio is not None and C is None:
        C = line_contact_first_yield(poisson_ratio).pressure_ratio
    elif C is None or poisson_ratio is not None:
        raise InputError("critical_line_values needs either poisson_ratio or C")
    values = numbers(
        radius=radius,
        contact_modulus=contact_modulus,
        C=C,
        yield_stress=yield_stress,
        length=length,
        reference=approach_origin(radius, reference),
    )
    return CriticalValues(*_core.critical_line_values(*values))
