# SPDX-License-Identifier: BSD-3-Clause
"""Sampling of a hardening law that is given as a function."""

from __future__ import annotations

import itertools
from collections.abc import Callable
from typing import Any, TypeAlias

import numpy as np

from brinell._arrays import require_unmasked
from brinell.errors import InputError

__all__ = ["Law", "sampled"]

Law: TypeAlias = Callable[[Any], Any]
"""User-defined hardening law: a function sigma_y(e) [Pa] that is called with one strain at a time."""


class _Checked:
    """Hardening law with checks: each value is a stress > 0, and the values do not decrease with the strain."""

    def __init__(self, law: Law):
        self._law = law
        self._known: dict[float, float] = {}

    def __call__(self, e: float) -> float:
        if e not in self._known:
            with np.errstate(all="ignore"):
                given = self._law(np.float64(e))
                require_unmasked(given, "what the hardening law gives")
            try:
                value = np.asarray(given, dtype=np.float64)
            except (TypeError, ValueError):
                raise InputError(
                    f"the hardening law gives {given!r} at a plastic strain of {e:g}; allowed: a stress in Pa"
                ) from None
            if value.size != 1 or not (np.isfinite(value).all() and value.item() > 0):
                raise InputError(
                    f"the hardening law gives {value} at a plastic strain of {e:g}; allowed: a stress in Pa"
                )
            self._known[e] = value.item()
        return self._known[e]

    def require_rise(self) -> None:
        """Raises InputError if the values so far decrease with the strain by more than rounding."""
        rounding = 1e-12
        points = sorted(self._known.items())
        for (_, before), (e, after) in itertools.pairwise(points):
            if after < before * (1 - rounding):
                raise InputError(
                    f"the hardening law falls from {before:g} Pa to {after:g} Pa before a plastic strain of {e:g}; "
                    "softening is not modelled"
                )


def sampled(function: Law, end: float) -> tuple[list[float], list[float]]:
    """Strains from 0 to `end` and the yield stresses there, so that linear interpolation is accurate to 1e-4.

    Intervals are halved until the law is linear in them, as judged by three interior points.

    Raises:
        InputError: the function returns an invalid value, decreases or jumps; the text says where.
    """
    law = _Checked(function)
    tolerance = 1e-4 / 2  # half of the promised error, as a margin between the three points
    coarsest = 32
    todo = [(end * (i - 1) / coarsest, end * i / coarsest) for i in range(coarsest, 0, -1)]
    strain = [0.0]
    while todo:
        left, right = todo.pop()
        straight = True
        for t in (0.25, 0.5, 0.75):
            line = (1 - t) * law(left) + t * law(right)
            straight = straight and abs(law(left + t * (right - left)) - line) <= tolerance * line
        middle = 0.5 * (left + right)
        if straight:
            strain.append(right)
        elif left < middle < right:
            todo += [(middle, right), (left, middle)]
        else:
            law.require_rise()
            raise InputError(
                f"the hardening law jumps from {law(left):g} Pa to {law(right):g} Pa at a plastic strain of {right:g}; "
                "allowed: a continuous one"
            )
    law.require_rise()
    return strain, np.maximum.accumulate([law(e) for e in strain]).tolist()
