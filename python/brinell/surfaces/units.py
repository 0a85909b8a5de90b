# SPDX-License-Identifier: BSD-3-Clause
"""Units of length, and pairs of lengths, for height maps."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from brinell import _core
from brinell.errors import InputError

_LENGTHS = "m, cm, mm, um, nm, pm, in, angstrom"


def metres(unit: str) -> float:
    """Factor from a unit of length to m.

    Raises:
        InputError: the unit is unknown.
    """
    try:
        return _core.length(f"1 {unit}")
    except InputError as error:
        raise InputError(f"unit = {unit!r} is no unit of length; allowed: {_LENGTHS}") from error


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
