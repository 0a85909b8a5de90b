# SPDX-License-Identifier: BSD-3-Clause
"""Units of lengths, and pairs of numbers, as surfaces are given."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from brinell import _core
from brinell.errors import InputError

_METRES = {"m": 1.0, "cm": 1e-2, "mm": 1e-3, "um": 1e-6, "µm": 1e-6, "μm": 1e-6, "nm": 1e-9, "pm": 1e-12, "Å": 1e-10}


def metres(unit: str) -> float:
    """What a unit of length is in m."""
    if unit not in _METRES:
        raise InputError(f"unit = {unit!r} is no unit of length; allowed: {', '.join(_METRES)}")
    return _METRES[unit]


def one_unit(told: str | None, given: str | None) -> str:
    """That of a file or object, or the one given because it tells none."""
    if told is not None and given is not None:
        raise InputError(f"tells its unit, {told}; leave out unit = {given!r}")
    unit = told or given
    if unit is None:
        raise InputError("tells no unit; give the argument unit, as unit='um'")
    return unit


def pair(values: ArrayLike) -> tuple[float, float]:
    """Two lengths [m], for x and y: numbers, or text with a unit; one stands for both."""
    is_one = isinstance(values, str) or np.ndim(values) == 0
    both = [values, values] if is_one else list(values)  # type: ignore[arg-type]
    if len(both) != 2:
        raise InputError(f"{values!r}; allowed: two numbers, for x and y")
    x, y = (_core.length(one) if isinstance(one, str) else float(one) for one in both)  # type: ignore[arg-type]
    return x, y
