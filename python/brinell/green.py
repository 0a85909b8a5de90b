# SPDX-License-Identifier: BSD-3-Clause
"""Closed-form solutions of the elastic half space z >= 0, z into the body: loaded rectangles and strained cuboids.

Coordinates are arrays that are broadcast against each other; (...) below is their common shape. Stresses are positive
in tension. Tensor components come first, in the order xx, yy, zz, yz, xz, xy; shear strains are tensor components, not
engineering shear.
"""

from __future__ import annotations

import sys

from numpy.typing import ArrayLike

from brinell import _core
from brinell._arguments import explain_argument_errors
from brinell._arrays import Array, contiguous, points, require_below, require_poisson, require_positive
from brinell.errors import InputError

__all__ = [
    "cuboid_stress",
    "cuboid_stress_half_space",
    "cuboid_surface_displacement",
    "rectangle_displacement",
    "rectangle_stress",
]

_TRACTIONS = {
    "pressure": _core.Traction.pressure,
    "shear_x": _core.Traction.shear_x,
    "shear_y": _core.Traction.shear_y,
}


def rectangle_displacement(x: ArrayLike, y: ArrayLike, dx: float, dy: float) -> Array:
    """Integral of 1/r over a rectangle for a point in the same plane (Love 1929; Johnson 1985, Eq. 3.25).

    A uniform pressure p on the rectangle displaces the surface by u_z = (1 - nu^2)/(pi E) p times this value.

    Args:
        x: points along x, from the rectangle's centre [m].
        y: points along y [m].
        dx: side along x [m].
        dy: side along y [m].

    Returns:
        (...) value of the integral, > 0 [m].
    """
    require_positive(dx=dx, dy=dy)
    shape, (x, y) = points(x=x, y=y)
    return _core.rectangle_displacement(x, y, dx, dy).reshape(shape)


def rectangle_stress(
    x: ArrayLike,
    y: ArrayLike,
    z: ArrayLike,
    dx: float,
    dy: float,
    poisson_ratio: float,
    traction: str = "pressure",
) -> Array:
    """Stress under a uniform unit traction on a rectangle of the surface (Love 1929; Cerruti).

    Args:
        x: points along x, from the rectangle's centre [m].
        y: points along y [m].
        z: depths [m], >= 0. On an edge at z = 0 the stress of a pressure is the mean of both sides; that of a shear is
            infinite.
        dx: side along x [m].
        dy: side along y [m].
        poisson_ratio: nu [-].
        traction: traction on the body: "pressure", "shear_x" or "shear_y".

    Returns:
        (6, ...) stress per traction [Pa/Pa]; just under the rectangle zz = -1 for a pressure, xz = -1 for a shear along
        x.
    """
    if traction not in _TRACTIONS:
        raise InputError(f"traction = {traction!r}; allowed: {', '.join(map(repr, _TRACTIONS))}")
    require_positive(dx=dx, dy=dy)
    shape, (x, y, z) = points(x=x, y=y, z=z)
    require_below(z)
    require_poisson(poisson_ratio)
    stress = _core.rectangle_stress(x, y, z, dx, dy, poisson_ratio, _TRACTIONS[traction])
    return stress.reshape(6, *shape)


def cuboid_stress(
    x: ArrayLike,
    y: ArrayLike,
    z: ArrayLike,
    dx: float,
    dy: float,
    dz: float,
    eigenstrain: ArrayLike,
    young_modulus: float,
    poisson_ratio: float,
) -> Array:
    """Stress in an infinite body by a cuboid with a uniform eigenstrain (Chiu 1977; Mura 1987, Section 11).

    Args:
        x: points along x, from the cuboid's centre [m]; not on an edge.
        y: points along y [m].
        z: points along z [m].
        dx: side along x [m].
        dy: side along y [m].
        dz: side along z [m].
        eigenstrain: (6,) plastic or thermal strain of any trace [-].
        young_modulus: E [Pa].
        poisson_ratio: nu [-].

    Returns:
        (6, ...) stress [Pa]; on a face, components that are discontinuous there have the mean of both sides.
    """
    require_positive(dx=dx, dy=dy, dz=dz, young_modulus=young_modulus)
    shape, (x, y, z) = points(x=x, y=y, z=z)
    strain = contiguous(eigenstrain, "eigenstrain")
    require_poisson(poisson_ratio)
    return _core.cuboid_stress(x, y, z, dx, dy, dz, strain, young_modulus, poisson_ratio).reshape(6, *shape)


def cuboid_stress_half_space(
    x: ArrayLike,
    y: ArrayLike,
    z: ArrayLike,
    zc: float,
    dx: float,
    dy: float,
    dz: float,
    eigenstrain: ArrayLike,
    young_modulus: float,
    poisson_ratio: float,
) -> Array:
    """Stress in a half space by a cuboid with a uniform eigenstrain under the free surface (Liu et al. 2012).

    Args:
        x: points along x, from the cuboid's centre [m]; not on an edge.
        y: points along y [m].
        z: depths [m], >= 0.
        zc: depth of the cuboid's centre [m], >= dz/2.
        dx: side along x [m].
        dy: side along y [m].
        dz: side along z [m].
        eigenstrain: (6,) plastic or thermal strain of any trace [-].
        young_modulus: E [Pa].
        poisson_ratio: nu [-].

    Returns:
        (6, ...) stress [Pa]; zz, yz and xz are zero on z = 0.
    """
    require_positive(dx=dx, dy=dy, dz=dz, young_modulus=young_modulus)
    _require_inside(zc, dz)
    shape, (x, y, z) = points(x=x, y=y, z=z)
    require_below(z)
    strain = contiguous(eigenstrain, "eigenstrain")
    require_poisson(poisson_ratio)
    stress = _core.cuboid_stress_half_space(x, y, z, zc, dx, dy, dz, strain, young_modulus, poisson_ratio)
    return stress.reshape(6, *shape)


def cuboid_surface_displacement(
    x: ArrayLike,
    y: ArrayLike,
    zc: float,
    dx: float,
    dy: float,
    dz: float,
    eigenstrain: ArrayLike,
    poisson_ratio: float,
) -> Array:
    """Normal displacement of the free surface over a cuboid with a uniform eigenstrain.

    Args:
        x: points along x, from the cuboid's centre [m].
        y: points along y [m].
        zc: depth of the cuboid's centre [m], >= dz/2.
        dx: side along x [m].
        dy: side along y [m].
        dz: side along z [m].
        eigenstrain: (6,) plastic or thermal strain of any trace [-].
        poisson_ratio: nu [-].

    Returns:
        (...) displacement, positive into the body [m]: a dilatation raises the surface, u_z < 0 (Mindlin, Cheng 1950).
    """
    require_positive(dx=dx, dy=dy, dz=dz)
    _require_inside(zc, dz)
    shape, (x, y) = points(x=x, y=y)
    strain = contiguous(eigenstrain, "eigenstrain")
    require_poisson(poisson_ratio)
    return _core.cuboid_surface_displacement(x, y, zc, dx, dy, dz, strain, poisson_ratio).reshape(shape)


def _require_inside(zc: float, dz: float) -> None:
    if not zc >= dz / 2:
        raise InputError(f"zc = {zc}; allowed: at least dz/2 = {dz / 2}, so that the cuboid is inside the body")


explain_argument_errors(sys.modules[__name__])
