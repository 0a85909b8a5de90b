# SPDX-License-Identifier: BSD-3-Clause
"""Elastic contacts in a point and along a line, and the stress under them (Hertz 1882)."""

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
        lower: one body.
        upper: the other one.

    Returns:
        E' [Pa].

    Raises:
        InputError: both are rigid.
    """
    return _core.contact_modulus(lower._engine, upper._engine)


@dataclass(frozen=True)
class PointContact:
    """Hertz contact of two spheres, with the pressure p0 sqrt(1 - r^2/a^2).

    Attributes:
        load: P = 4/3 E' sqrt(R) approach^1.5 [N].
        approach: of distant points, a^2/R [m].
        contact_radius: a [m].
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
        radius: R [m].
        contact_modulus: E' [Pa].
        load: [N], >= 0.
        approach: instead of the load [m], >= 0.

    Returns:
        Radius, approach, load and pressures of the contact.

    Raises:
        InputError: a value is out of range, or not one of load and approach is given.
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
    """Hertz contact with an elliptical area and the pressure p0 sqrt(1 - x^2/a_x^2 - y^2/a_y^2).

    Attributes:
        load: P = 2/3 pi a_x a_y p0 [N].
        approach: of distant points [m].
        semi_axis_x: a_x [m].
        semi_axis_y: a_y [m].
        peak_pressure: p0 [Pa].
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
        radius_x: of relative curvature: the undeformed gap is x^2/(2 radius_x) + y^2/(2 radius_y) [m].
        radius_y: [m].
        contact_modulus: E' [Pa].
        load: [N], >= 0.
        approach: instead of the load [m], >= 0.

    Raises:
        InputError: a value is out of range, or not one of load and approach is given.
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
        load_per_length: W [N/m].
        half_width: a = sqrt(4 W R/(pi E')) [m].
        peak_pressure: p0 = 2 W/(pi a) [Pa].
        approach: W/(pi E') (1 + 2 ln(2 l/a)) with the reference distance l [m].
    """

    load_per_length: float
    half_width: float
    peak_pressure: float
    approach: float


def approach_origin(radius: float, reference: float | None) -> float:
    """Distance from which the approach of cylinders counts: as given, or 2 R/e."""
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
        radius: R [m].
        contact_modulus: E' [Pa].
        load_per_length: [N/m], >= 0.
        approach: instead of the load [m], >= 0.
        reference: distance l of a line load at which its displacement counts as zero [m]; None: 2 R/e. More than half
            the half-width of the contact.

    Raises:
        InputError: a value is out of range, or not one of load_per_length and approach is given.
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
    """Stress under a point contact (Huber 1904), also one that slides (Hamilton 1983).

    Args:
        x: points along x, from the contact's centre [m]; broadcast against y and z to the shape (...).
        y: points along y [m].
        z: depths [m], >= 0.
        contact_radius: a [m].
        peak_pressure: p0 [Pa].
        poisson_ratio: nu [-].
        friction: shear on the body towards +x, over the pressure [-]; below 0 towards -x.

    Returns:
        (6, ...) [Pa].
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
    """Stress under a line contact in plane strain, also one that slides (McEwen 1949; Johnson 1985, Eqs. 4.49, 7.8).

    Args:
        x: points across the line, from its middle [m]; broadcast against z to the shape (...).
        z: depths [m], >= 0.
        half_width: a [m].
        peak_pressure: p0 [Pa].
        poisson_ratio: nu [-].
        friction: shear on the body towards +x, over the pressure [-]; below 0 towards -x.

    Returns:
        (6, ...) [Pa].
    """
    shape, (x, z) = points(x=x, z=z)
    require_below(z)
    require_positive(half_width=half_width)
    require_poisson(poisson_ratio)
    values = numbers(half_width=half_width, peak_pressure=peak_pressure, poisson_ratio=poisson_ratio, friction=friction)
    return _core.line_contact_stress(x, z, *values).reshape(6, *shape)
