# SPDX-License-Identifier: BSD-3-Clause
"""Published fits to finite-element solutions of an elastic-perfectly-plastic sphere and a rigid flat."""

from __future__ import annotations

from numpy.typing import ArrayLike

from brinell import _core
from brinell._arrays import Array, points, require_poisson


def jackson_green_pressure_ratio(poisson_ratio: float) -> float:
    """C(nu) = 1.295 exp(0.736 nu), the ratio p0/S_y at first yield by Jackson and Green (2005)."""
    require_poisson(poisson_ratio)
    return _core.jackson_green_pressure_ratio(poisson_ratio)


def jackson_green_area(
    interference_ratio: ArrayLike, young_modulus: float, poisson_ratio: float, yield_stress: float
) -> Array:
    """Contact area of an elastic-perfectly-plastic sphere and a rigid flat, over pi R alpha_c (Jackson, Green 2005).

    Args:
        interference_ratio: (...) approach over the approach at first yield [-].
        young_modulus: E of the sphere [Pa].
        poisson_ratio: nu of the sphere [-].
        yield_stress: S_y of the sphere [Pa].

    Returns:
        (...) area ratio [-].
    """
    shape, (ratio,) = points(interference_ratio=interference_ratio)
    require_poisson(poisson_ratio)
    return _core.jackson_green_area(ratio, young_modulus, poisson_ratio, yield_stress).reshape(shape)


def jackson_green_load(
    interference_ratio: ArrayLike, young_modulus: float, poisson_ratio: float, yield_stress: float
) -> Array:
    """Load of an elastic-perfectly-plastic sphere on a rigid flat, over P_c (Jackson, Green 2005).

    Args:
        interference_ratio: (...) approach over the approach at first yield [-].
        young_modulus: E of the sphere [Pa].
        poisson_ratio: nu of the sphere [-].
        yield_stress: S_y of the sphere [Pa].

    Returns:
        (...) load ratio [-]; the Hertz solution below an interference ratio of 1.9.
    """
    shape, (ratio,) = points(interference_ratio=interference_ratio)
    require_poisson(poisson_ratio)
    return _core.jackson_green_load(ratio, young_modulus, poisson_ratio, yield_stress).reshape(shape)


def kogut_etsion_load(interference_ratio: ArrayLike) -> Array:
    """Load of an elastic-perfectly-plastic sphere on a rigid flat, over P_c (Kogut, Etsion 2002).

    Args:
        interference_ratio: (...) approach over the approach at first yield, in (0, 110] [-].

    Returns:
        (...) load ratio [-]; the fit jumps by 3 % at an interference ratio of 1 and by 2 % at 6.
    """
    shape, (ratio,) = points(interference_ratio=interference_ratio)
    return _core.kogut_etsion_load(ratio).reshape(shape)
