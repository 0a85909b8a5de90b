# SPDX-License-Identifier: BSD-3-Clause
"""Closed-form solutions to lay beside a computation: Hertz, first yield, indented spheres, elastic tugging.

Cylinders are in plane strain. Their approach has a logarithm without end: it counts from a reference distance l, by
default 2 R/e, with which it is that of Green (2005).

z points into the body, pressure is positive in compression, stress in tension; tensor components come first, in the
order xx, yy, zz, yz, xz, xy. R is the equivalent radius, 1/R = 1/R1 + 1/R2; E' the contact modulus,
1/E' = (1 - nu1^2)/E1 + (1 - nu2^2)/E2.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

from numpy.typing import ArrayLike

from brinell import _core
from brinell._arrays import Array, points, require_below, require_poisson, require_positive
from brinell.errors import InputError
from brinell.materials import RIGID, Material

__all__ = [
    "CriticalValues",
    "ElasticTugging",
    "EllipticalContact",
    "FirstYield",
    "LineContact",
    "PointContact",
    "TuggingForces",
    "contact_modulus",
    "critical_line_values",
    "critical_pressure_ratio",
    "critical_values",
    "elastic_tugging_forces",
    "elastic_tugging_reach",
    "elliptical_contact",
    "first_yield",
    "jackson_green_area",
    "jackson_green_load",
    "jackson_green_pressure_ratio",
    "kogut_etsion_load",
    "line_contact",
    "line_contact_first_yield",
    "line_contact_stress",
    "point_contact",
    "point_contact_stress",
]


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

    Raises:
        InputError: a value is out of range, or not one of load and approach is given.
    """
    if load is not None and approach is None:
        return PointContact(*_core.point_contact_at_load(radius, contact_modulus, load))
    if approach is not None and load is None:
        return PointContact(*_core.point_contact_at_approach(radius, contact_modulus, approach))
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
    if load is not None and approach is None:
        return EllipticalContact(*_core.elliptical_contact_at_load(radius_x, radius_y, contact_modulus, load))
    if approach is not None and load is None:
        return EllipticalContact(*_core.elliptical_contact_at_approach(radius_x, radius_y, contact_modulus, approach))
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


def _reference(radius: float, reference: float | None) -> float:
    """As given, or 2 R/e."""
    return 2.0 * radius / math.e if reference is None else reference


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
    origin = _reference(radius, reference)
    if load_per_length is not None and approach is None:
        return LineContact(*_core.line_contact_at_load(radius, contact_modulus, load_per_length, origin))
    if approach is not None and load_per_length is None:
        return LineContact(*_core.line_contact_at_approach(radius, contact_modulus, approach, origin))
    raise InputError("line_contact needs either load_per_length or approach")


def point_contact_stress(
    x: ArrayLike, y: ArrayLike, z: ArrayLike, contact_radius: float, peak_pressure: float, poisson_ratio: float
) -> Array:
    """Stress under a point contact (Huber 1904; Hamilton 1983 without friction).

    Args:
        x: points along x, from the contact's centre [m]; broadcast against y and z to the shape (...).
        y: points along y [m].
        z: depths [m], >= 0.
        contact_radius: a [m].
        peak_pressure: p0 [Pa].
        poisson_ratio: nu [-].

    Returns:
        (6, ...) [Pa].
    """
    shape, (x, y, z) = points(x=x, y=y, z=z)
    require_below(z)
    require_positive(contact_radius=contact_radius)
    require_poisson(poisson_ratio)
    return _core.point_contact_stress(x, y, z, contact_radius, peak_pressure, poisson_ratio).reshape(6, *shape)


def line_contact_stress(
    x: ArrayLike, z: ArrayLike, half_width: float, peak_pressure: float, poisson_ratio: float
) -> Array:
    """Stress under a line contact in plane strain (McEwen 1949; Johnson 1985, Eqs. 4.49).

    Args:
        x: points across the line, from its middle [m]; broadcast against z to the shape (...).
        z: depths [m], >= 0.
        half_width: a [m].
        peak_pressure: p0 [Pa].
        poisson_ratio: nu [-].

    Returns:
        (6, ...) [Pa].
    """
    shape, (x, z) = points(x=x, z=z)
    require_below(z)
    require_positive(half_width=half_width)
    require_poisson(poisson_ratio)
    return _core.line_contact_stress(x, z, half_width, peak_pressure, poisson_ratio).reshape(6, *shape)


@dataclass(frozen=True)
class FirstYield:
    """Where a frictionless contact yields first.

    Attributes:
        pressure_ratio: C = p0/S_y = p0/(largest von Mises stress) [-].
        depth_ratio: depth over contact radius, or half-width of a line contact [-].
    """

    pressure_ratio: float
    depth_ratio: float


def first_yield(poisson_ratio: float) -> FirstYield:
    """First yield by von Mises on the axis of a point contact, exact.

    Args:
        poisson_ratio: nu, in [0, 0.5].

    Raises:
        InputError: nu is out of range.
    """
    return FirstYield(*_core.first_yield(poisson_ratio))


def line_contact_first_yield(poisson_ratio: float) -> FirstYield:
    """First yield by von Mises of a line contact in plane strain, exact: on its axis, up to nu = 0.1938 at the surface.

    Green's (2005) fits are within 0.15 % of it.

    Args:
        poisson_ratio: nu, in (-1, 0.5].

    Raises:
        InputError: nu is out of range.
    """
    return FirstYield(*_core.line_contact_first_yield(poisson_ratio))


def critical_pressure_ratio(poisson_ratio: float) -> float:
    """C(nu) = 1.30075 + 0.87825 nu + 0.54373 nu^2, a fit of p0/S_y at first yield (Green 2005), within 0.15 %."""
    require_poisson(poisson_ratio)
    return _core.critical_pressure_ratio(poisson_ratio)


@dataclass(frozen=True)
class CriticalValues:
    """First yield of a frictionless contact, in a point or along a line.

    Attributes:
        C: p0/S_y [-].
        interference: alpha_c [m].
        load: P_c [N].
        energy: U_c [J].
        contact_radius: a_c, of a line its half-width [m].
        contact_area: pi a_c^2, of a line of the length L 2 a_c L [m²].
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
        yield_stress: S_y of the body that yields first, that with the smaller C S_y [Pa].
        poisson_ratio: nu of that body; C is `critical_pressure_ratio` of it.
        C: instead of nu: p0/S_y at first yield.

    Raises:
        InputError: a value is out of range, or not one of poisson_ratio and C is given.
    """
    require_positive(radius=radius, contact_modulus=contact_modulus, yield_stress=yield_stress)
    if poisson_ratio is not None and C is None:
        C = critical_pressure_ratio(poisson_ratio)
    elif C is None or poisson_ratio is not None:
        raise InputError("critical_values needs either poisson_ratio or C")
    return CriticalValues(*_core.critical_values(radius, contact_modulus, C, yield_stress))


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
        yield_stress: S_y of the body that yields first, that with the smaller C S_y [Pa].
        poisson_ratio: nu of that body; C is that of `line_contact_first_yield`.
        C: instead of nu: p0/S_y at first yield.
        length: on which load, energy and area are [m].
        reference: distance l from which the approach counts [m]; None: 2 R/e, as in Green's formulae.

    Raises:
        InputError: a value is out of range, or not one of poisson_ratio and C is given.
    """
    require_positive(radius=radius, contact_modulus=contact_modulus, yield_stress=yield_stress)
    if poisson_ratio is not None and C is None:
        C = line_contact_first_yield(poisson_ratio).pressure_ratio
    elif C is None or poisson_ratio is not None:
        raise InputError("critical_line_values needs either poisson_ratio or C")
    origin = _reference(radius, reference)
    return CriticalValues(*_core.critical_line_values(radius, contact_modulus, C, yield_stress, length, origin))


def jackson_green_pressure_ratio(poisson_ratio: float) -> float:
    """C(nu) = 1.295 exp(0.736 nu), p0/S_y at first yield as Jackson and Green (2005) have it."""
    require_poisson(poisson_ratio)
    return _core.jackson_green_pressure_ratio(poisson_ratio)


def jackson_green_area(
    interference_ratio: ArrayLike, young_modulus: float, poisson_ratio: float, yield_stress: float
) -> Array:
    """Contact area of an elastic-perfectly-plastic sphere and a rigid flat, over pi R alpha_c (Jackson, Green 2005).

    Args:
        interference_ratio: (...), approach over that at first yield [-].
        young_modulus: E of the sphere [Pa].
        poisson_ratio: nu of the sphere [-].
        yield_stress: S_y of the sphere [Pa].

    Returns:
        (...) [-].
    """
    shape, (ratio,) = points(interference_ratio=interference_ratio)
    require_poisson(poisson_ratio)
    return _core.jackson_green_area(ratio, young_modulus, poisson_ratio, yield_stress).reshape(shape)


def jackson_green_load(
    interference_ratio: ArrayLike, young_modulus: float, poisson_ratio: float, yield_stress: float
) -> Array:
    """Load of an elastic-perfectly-plastic sphere on a rigid flat, over P_c (Jackson, Green 2005).

    Args:
        interference_ratio: (...), approach over that at first yield [-].
        young_modulus: E of the sphere [Pa].
        poisson_ratio: nu of the sphere [-].
        yield_stress: S_y of the sphere [Pa].

    Returns:
        (...) [-]; Hertz below a ratio of 1.9.
    """
    shape, (ratio,) = points(interference_ratio=interference_ratio)
    require_poisson(poisson_ratio)
    return _core.jackson_green_load(ratio, young_modulus, poisson_ratio, yield_stress).reshape(shape)


def kogut_etsion_load(interference_ratio: ArrayLike) -> Array:
    """Load of an elastic-perfectly-plastic sphere on a rigid flat, over P_c (Kogut, Etsion 2002).

    Args:
        interference_ratio: (...), approach over that at first yield, in (0, 110] [-].

    Returns:
        (...) [-]; the fit has steps of 3 % at 1 and of 2 % at 6.
    """
    shape, (ratio,) = points(interference_ratio=interference_ratio)
    return _core.kogut_etsion_load(ratio).reshape(shape)


@dataclass(frozen=True)
class TuggingForces:
    """Forces of two elastic spheres or cylinders that pass each other.

    Attributes:
        load: P along the line of centres (...) [N].
        F_X: positive if it resists the motion, before alignment (...) [N].
        F_Z: presses them apart (...) [N].
        interference: of the undeformed bodies, 0 without contact (...) [m].
    """

    load: Array
    F_X: Array
    F_Z: Array
    interference: Array


class ElasticTugging:
    """Two elastic bodies of which the upper is carried past the lower one at constant height, without friction.

    At the sliding coordinate X the centres are omega' apart, omega'^2 = omega^2 + X^2, omega = R1 + R2 - interference,
    and F_X = -P X/omega', F_Z = P omega/omega'. P is that of the approach R1 + R2 - omega': 4/3 E' sqrt(R) approach^1.5
    of spheres, and of cylinders that of `line_contact` over their length.
    """

    def __init__(
        self,
        radius_lower: float,
        radius_upper: float,
        contact_modulus: float,
        interference: float,
        *,
        length: float | None = None,
        reference: float | None = None,
    ):
        """Two spheres, or cylinders in plane strain if a length is given.

        Args:
            radius_lower: R1 [m].
            radius_upper: R2 [m].
            contact_modulus: E' [Pa].
            interference: at alignment [m], in (0, R1 + R2).
            length: of cylinders, on which forces and energies are [m].
            reference: of cylinders: distance l from which the approach counts [m]; None: 2 R/e.

        Raises:
            InputError: a value is out of range.
        """
        if length is None and reference is not None:
            raise InputError("reference goes with cylinders: give their length")
        require_positive(radius_lower=radius_lower, radius_upper=radius_upper)
        radius = 1.0 / (1.0 / radius_lower + 1.0 / radius_upper)
        line = None if length is None else (length, _reference(radius, reference))
        self._engine = _core.ElasticTugging(radius_lower, radius_upper, contact_modulus, interference, line)

    @property
    def half_sliding_distance(self) -> float:
        """The bodies touch from -d0 to d0 [m] (Boucly, Nelias, Green 2006, Eq. 2)."""
        return self._engine.half_sliding_distance()

    def forces(self, X: ArrayLike) -> TuggingForces:
        """Forces at the sliding coordinates X (...) [m], 0 at alignment."""
        shape, (X,) = points(X=X)
        return TuggingForces(*self._engine.forces(X).reshape(4, *shape))

    def peak(self) -> tuple[float, float]:
        """The largest F_X [N] and the X < 0 where it is [m]."""
        return self._engine.peak()

    def work(self, X1: float, X2: float) -> float:
        """Work of F_X from X1 to X2 [J]."""
        return self._engine.work(X1, X2)


def elastic_tugging_reach(lower_radius: float, upper_radius: float, interference: float) -> float:
    """Sliding coordinate at which two elastic spheres or cylinders part, d0 (Boucly, Nelias, Green 2006, Eq. 2).

    Args:
        lower_radius: radius of the lower sphere [m].
        upper_radius: radius of the upper sphere [m].
        interference: rigid-body interference at alignment [m], > 0.

    Returns:
        Half the sliding distance in contact [m]; the contact lasts from -d0 to d0.
    """
    return ElasticTugging(lower_radius, upper_radius, 1.0, interference).half_sliding_distance


def elastic_tugging_forces(
    X: ArrayLike,
    lower_radius: float,
    upper_radius: float,
    interference: float,
    critical_interference: float,
    *,
    reference: float | None = None,
) -> tuple[Array, Array]:
    """Forces of two elastic spheres or cylinders over the critical load, for which no elastic constant is needed.

    Args:
        X: sliding coordinate, 0 at alignment [m].
        lower_radius: radius of the lower body [m].
        upper_radius: radius of the upper body [m].
        interference: rigid-body interference at alignment [m], > 0.
        critical_interference: interference at first yield, alpha_c [m].
        reference: of cylinders: distance l from which their approach counts [m]; None: spheres.

    Returns:
        F_X / P_c and F_Z / P_c [-], zero where they do not touch.
    """
    radius = 1.0 / (1.0 / lower_radius + 1.0 / upper_radius)
    if reference is None:
        critical_load = point_contact(radius, 1.0, approach=critical_interference).load
        forces = ElasticTugging(lower_radius, upper_radius, 1.0, interference).forces(X)
    else:
        critical_load = line_contact(radius, 1.0, approach=critical_interference, reference=reference).load_per_length
        cylinders = ElasticTugging(lower_radius, upper_radius, 1.0, interference, length=1.0, reference=reference)
        forces = cylinders.forces(X)
    return forces.F_X / critical_load, forces.F_Z / critical_load
