# SPDX-License-Identifier: BSD-3-Clause
"""Elastic point and line contacts, and the stress under them (Hertz 1882)."""

from __future__ import annotations

import math
from dataclasses import dataclass

from numpy.typing import ArrayLike

from brinell import _core
from brinell._arrays import Array, number, numbers, points, require_below, require_poisson, require_positive
from brinell.errors import InputError
from brinell.materials import RIGID, Material


def contact_modulus(lower: Material, upper: Material = RIGID) -> float:
    """Contact modulus E' of two bodies (Johnson 1985, Eq. 4.4).

    Args:
        lower: material of the lower body.
        upper: material of the upper body.

    Returns:
        Contact modulus E' [Pa].

    Raises:
        InputError: both bodies are rigid.
    """
    return _core.contact_modulus(lower._engine, upper._engine)


@dataclass(frozen=True)
class PointContact:
    """Hertz contact of two spheres, with the pressure p0 sqrt(1 - r^2/a^2).

    Attributes:
        load: P = 4/3 E' sqrt(R) approach^1.5 [N].
        approach: approach of distant points, a^2/R [m].
        contact_radius: contact radius a [m].
        peak_pressure: p0 = 3 P/(2 pi a^2) [Pa].
    """

    load: float
    approach: float
    contact_radius: float
    peak_pressure: float


def point_contact(
    radius: float, contact_modulus: float, *, load: float | None = None, approach: float | None = None
) -> PointContact:
    """Contact of spheres (Hertz 1882; Johnson 1985, Eqs. 4.22-4.24).

    Args:
        radius: equivalent radius R [m].
        contact_modulus: contact modulus E' [Pa].
        load: normal load, >= 0 [N].
        approach: approach instead of the load, >= 0 [m].

    Returns:
        Load, approach, radius and peak pressure of the contact.

    Raises:
        InputError: a value is out of range, or not exactly one of load and approach is given.
    """
    if load is not None and approach is None:
        values = numbers(radius=radius, contact_modulus=contact_modulus, load=load)
        return PointContact(*_core.point_contact_at_load(*values))
    if approach is not None and load is None:
        values = numbers(radius=radius, contact_modulus=contact_modulus, approach=approach)
        return PointContact(*_core.point_contact_at_approach(*values))
    raise InputError("point_contact needs either load or approach")


@dataclass(frozen=True)
class EllipticalContact:
    """Hertz contact with an elliptical contact area and the pressure p0 sqrt(1 - x^2/a_x^2 - y^2/a_y^2).

    Attributes:
        load: P = 2/3 pi a_x a_y p0 [N].
        approach: approach of distant points [m].
        semi_axis_x: semi-axis a_x of the contact area [m].
        semi_axis_y: semi-axis a_y of the contact area [m].
        peak_pressure: peak pressure p0 [Pa].
    """

    load: float
    approach: float
    semi_axis_x: float
    semi_axis_y: float
    peak_pressure: float


def elliptical_contact(
    radius_x: float,
    radius_y: float,
    contact_modulus: float,
    *,
    load: float | None = None,
    approach: float | None = None,
) -> EllipticalContact:
    """Contact of surfaces with two curvatures (Hertz 1882; Johnson 1985, Eqs. 4.26-4.33).

    Args:
        radius_x: radius of relative curvature along x [m]: the undeformed gap is x^2/(2 radius_x) + y^2/(2 radius_y).
        radius_y: radius of relative curvature along y [m].
        contact_modulus: contact modulus E' [Pa].
        load: normal load, >= 0 [N].
        approach: approach instead of the load, >= 0 [m].

    Raises:
        InputError: a value is out of range, or not exactly one of load and approach is given.
    """
    bodies = {"radius_x": radius_x, "radius_y": radius_y, "contact_modulus": contact_modulus}
    if load is not None and approach is None:
        return EllipticalContact(*_core.elliptical_contact_at_load(*numbers(**bodies, load=load)))
    if approach is not None and load is None:
        return EllipticalContact(*_core.elliptical_contact_at_approach(*numbers(**bodies, approach=approach)))
    raise InputError("elliptical_contact needs either load or approach")


@dataclass(frozen=True)
class LineContact:
    """Hertz contact along a line (y), with the pressure p0 sqrt(1 - x^2/a^2).

    Attributes:
        load_per_length: load per length W [N/m].
        half_width: a = sqrt(4 W R/(pi E')) [m].
        peak_pressure: p0 = 2 W/(pi a) [Pa].
        approach: W/(pi E') (1 + 2 ln(2 l/a)), with the reference distance l [m].
    """

    load_per_length: float
    half_width: float
    peak_pressure: float
    approach: float


def approach_origin(radius: float, reference: float | None) -> float:
    """Reference distance of the approach of cylinders [m]: the given one, or 2 R/e."""
    return 2.0 * number(radius, "radius") / math.e if reference is None else number(reference, "reference")


def line_contact(
    radius: float,
    contact_modulus: float,
    load_per_length: float | None = None,
    *,
    approach: float | None = None,
    reference: float | None = None,
) -> LineContact:
    """Contact of cylinders (Hertz 1882; Johnson 1985, Eqs. 4.43-4.45 and 5.56).

    Args:
        radius: equivalent radius R [m].
        contact_modulus: contact modulus E' [Pa].
        load_per_length: load per length, >= 0 [N/m].
        approach: approach instead of the load, >= 0 [m].
        reference: distance l from a line load at which its displacement is set to zero [m]; None: 2 R/e. It must exceed
            half the half-width of the contact.

    Raises:
        InputError: a value is out of range, or not exactly one of load_per_length and approach is given.
    """
    origin = approach_origin(radius, reference)
    bodies = {"radius": radius, "contact_modulus": contact_modulus}
    if load_per_length is not None and approach is None:
        values = numbers(**bodies, load_per_length=load_per_length, reference=origin)
        return LineContact(*_core.line_contact_at_load(*values))
    if approach is not None and load_per_length is None:
        return LineContact(*_core.line_contact_at_approach(*numbers(**bodies, approach=approach, reference=origin)))
    raise InputError("line_contact needs either load_per_length or approach")


def point_contact_stress(
    x: ArrayLike,
    y: ArrayLike,
    z: ArrayLike,
    contact_radius: float,
    peak_pressure: float,
    poisson_ratio: float,
    friction: float = 0.0,
) -> Array:
    """Stress under a point contact without friction (Huber 1904) or in sliding (Hamilton 1983).

    Args:
        x: points along x, from the contact's centre [m]; broadcast against y and z to the shape (...).
        y: points along y [m].
        z: depths [m], >= 0.
        contact_radius: contact radius a [m].
        peak_pressure: peak pressure p0 [Pa].
        poisson_ratio: nu [-].
        friction: shear on the body towards +x over the pressure; negative values act towards -x [-].

    Returns:
        (6, ...) stress [Pa].
    """
    shape, (x, y, z) = points(x=x, y=y, z=z)
    require_below(z)
    require_positive(contact_radius=contact_radius)
    require_poisson(poisson_ratio)
    values = numbers(
        contact_radius=contact_radius, peak_pressure=peak_pressure, poisson_ratio=poisson_ratio, friction=friction
    )
    return _core.point_contact_stress(x, y, z, *values).reshape(6, *shape)


def line_contact_stress(
    x: ArrayLike,
    z: ArrayLike,
    half_width: float,
    peak_pressure: float,
    poisson_ratio: float,
    friction: float = 0.0,
) -> Array:
    """Stress under a line contact in plane strain, at rest or sliding (McEwen 1949; Johnson 1985, Eqs. 4.49, 7.8).

    Args:
        x: points across the line, from its middle [m]; broadcast against z to the shape (...).
        z: depths [m], >= 0.
        half_width: half-width a of the contact [m].
        peak_pressure: peak pressure p0 [Pa].
        poisson_ratio: nu [-].
        friction: shear on the body towards +x over the pressure; negative values act towards -x [-].

    Returns:
        (6, ...) stress [Pa].
    """
    shape, (x, z) = points(x=x, z=z)
    require_below(z)
    require_positive(half_width=half_width)
    require_poisson(poisson_ratio)
    values = numbers(half_width=half_width, peak_pressure=peak_pressure, poisson_ratio=poisson_ratio, friction=friction)
    return _core.line_contact_stress(x, z, *values).reshape(6, *shape)
