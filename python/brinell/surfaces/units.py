# SPDX-License-Identifier: BSD-3-Clause
"""Units of length, and pairs of lengths, for height maps."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from brinell import _core
from brinell.errors import InputError

_METRES = {
    "m": 1.0,
    "cm": 1e-2,
    "mm": 1e-3,
    "um": 1e-6,
    "µm": 1e-6,
    "μm": 1e-6,
    "nm": 1e-9,
    "pm": 1e-12,
    "Å": 1e-10,
    "angstrom": 1e-10,
    "in": 0.0254,
    "inch": 0.0254,
}


def metres(unit: str) -> float:
    """Factor from a unit of length to m.

    Raises:
        InputError: the unit is unknown.
    """
    if unit not in _METRES:
        raise InputError(f"unit = {unit!r} is no unit of length; allowed: {', '.join(_METRES)}")
    return _METRES[unit]


def one_unit(stored: str | None, given: str | None) -> str:
    """Unit that is stored in a file or object, or the one that the user gives because none is stored.

    Raises:
        InputError: there is no unit, or both are present.
    """
    if stored is not None and given is not None:
        raise InputError(f"tells its unit, {stored}; leave out unit = {given!r}")
    unit = stored or given
    if unit is None:
        raise InputError("tells no unit; give the argument unit, as unit='um'")
    return unit


def pair(values: ArrayLike) -> tuple[float, float]:
    """Converts a pair of lengths for x and y, as numbers [m] or text with a unit, to m; one value stands for both."""
    is_one = isinstance(values, str) or np.ndim(values) == 0
    both = [values, values] if is_one else list(values)  # type: ignore[arg-type]
    if len(both) != 2:
        raise InputError(f"{values!r}; allowed: two numbers, for x and y")
    x, y = (_core.length(one) if isinstance(one, str) else float(one) for one in both)  # type: ignore[arg-type]
    return x, y
