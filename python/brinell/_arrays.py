# SPDX-License-Identifier: BSD-3-Clause
"""Checks and conversion of arguments for the engine, which uses contiguous arrays of doubles in place."""

from __future__ import annotations

import math
from typing import TypeAlias

import numpy as np
from numpy.typing import ArrayLike, NDArray

from brinell.errors import InputError

__all__ = [
    "Array",
    "contiguous",
    "number",
    "numbers",
    "points",
    "require_below",
    "require_poisson",
    "require_positive",
    "require_unmasked",
]

Array: TypeAlias = NDArray[np.float64]


def contiguous(values: ArrayLike, name: str) -> Array:
    """Converts values to a C-contiguous array of doubles (x fastest); copies only if that is necessary.

    Args:
        values: array of any real type.
        name: name of the argument, for the error message.

    Raises:
        InputError: the values are not real and finite, or some are masked.
    """
    require_unmasked(values, name)
    try:
        given = np.asarray(values)
        array = np.asarray(given, dtype=np.float64, order="C") if given.dtype.kind in "biuf" else None
    except ValueError:  # ragged lists
        array = None
    if array is None:
        raise InputError(f"{name} is not an array of real numbers")
    if not np.isfinite(array).all():
        raise InputError(f"{name} has values that are not finite")
    return array


def require_unmasked(values: object, name: str) -> None:
    """Raises InputError if an array has masked values: NumPy would use the numbers under the mask."""
    masked = int(np.count_nonzero(np.ma.getmaskarray(values))) if isinstance(values, np.ma.MaskedArray) else 0
    if masked > 0:
        raise InputError(
            f"{name} has {masked} masked values; allowed: a value everywhere, as numpy.ma.filled(values, 0.0) puts one"
        )


_UNITS = {
    "load_per_length": "N/m",
    **dict.fromkeys(("load", "force_x", "force_y"), "N"),
    **dict.fromkeys(("approach", "mean_gap", "shift_x", "shift_y", "reference", "scale", "depths"), "m"),
    **dict.fromkeys(("dx", "dy", "dz", "radius", "radius_lower", "radius_upper", "contact_radius", "half_width"), "m"),
    **dict.fromkeys(("radius_x", "radius_y", "length", "interference"), "m"),
    **dict.fromkeys(("young_modulus", "contact_modulus", "yield_stress", "peak_pressure"), "Pa"),
    **dict.fromkeys(("shortest_step", "duration", "later"), "s"),
    "spin": "rad",
    "velocity": "m/s",
    **dict.fromkeys(("friction", "poisson_ratio", "C"), ""),
}
"""Units of scalar arguments by their names, for error messages; a name that is missing here is reported as SI."""


def number(value: object, name: str) -> float:
    """Converts a scalar argument to a finite float.

    Raises:
        InputError: the value is not a finite number. Text with a unit is refused, too: only cases and materials
            accept it.
    """
    unit = _UNITS.get(name, "SI")
    allowed = f"a finite number, in {unit}" if unit else "a finite number without a unit"
    if isinstance(value, str):
        raise InputError(f"{name} = {value!r} is text; allowed: {allowed}. Cases and materials alone read units")
    if isinstance(value, list | tuple) or (isinstance(value, np.ndarray) and value.ndim > 0):
        raise InputError(f"{name} has {len(value)} values; allowed: one, {allowed}")
    try:
        result = float(value)  # type: ignore[arg-type]
    except (TypeError, ValueError):
        result = math.nan
    if math.isfinite(result):
        return result
    raise InputError(f"{name} = {value!r}; allowed: {allowed}")


def numbers(**values: object) -> list[float]:
    """Converts several scalar arguments, given by their names, as `number` does.

    Raises:
        InputError: a value is not a finite number.
    """
    return [number(value, name) for name, value in values.items()]


def points(**coordinates: ArrayLike) -> tuple[tuple[int, ...], list[Array]]:
    """Broadcasts coordinates of points against each other.

    Returns:
        The common shape, and each coordinate as a flat array of that size.

    Raises:
        InputError: the shapes cannot be broadcast to a common shape.
    """
    arrays = [contiguous(values, name) for name, values in coordinates.items()]
    try:
        broadcast = np.broadcast_arrays(*arrays)
    except ValueError:
        shapes = ", ".join(f"{name} {array.shape}" for name, array in zip(coordinates, arrays, strict=True))
        raise InputError(f"the shapes of the coordinates do not go together: {shapes}") from None
    return broadcast[0].shape, [np.ascontiguousarray(array).reshape(-1) for array in broadcast]


def require_positive(**values: float) -> None:
    """Raises InputError unless all the values are above 0."""
    for name, value in values.items():
        if not number(value, name) > 0:
            raise InputError(f"{name} = {value}; allowed: above 0")


def require_below(z: Array) -> None:
    """Raises InputError if a depth is negative."""
    if (z < 0).any():
        raise InputError(f"z has the value {z.min()}; allowed: not below 0, z points into the body")


def require_poisson(poisson_ratio: object) -> None:
    """Checks a Poisson's ratio.

    Raises:
        InputError: the value is not in (-1, 0.5].
    """
    if not -1.0 < number(poisson_ratio, "poisson_ratio") <= 0.5:
        raise InputError(f"poisson_ratio = {poisson_ratio}; allowed: in (-1, 0.5]. A steel has about 0.3")
