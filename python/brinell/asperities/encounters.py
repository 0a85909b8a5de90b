# SPDX-License-Identifier: BSD-3-Clause
"""Asperities that lie somewhere, and meet one by one: what sums are checked against, and what one experiment shows."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from brinell._arrays import number
from brinell.asperities.pairs import reach
from brinell.asperities.population import Population
from brinell.errors import InputError

__all__ = ["Encounters", "encounters"]

FloatArray = NDArray[np.float64]

_ROUNDING = 1e-9


@dataclass(frozen=True, eq=False)
class Encounters:
    """Passes of two asperities each, one entry per pass.

    Attributes:
        lower: number of the asperity in its population.
        upper: the same of the upper surface.
        interference: overlap of their tops in height [m].
        offset: of the upper centre from the lower one across the motion [m].
        lower_radius: [m].
        upper_radius: [m].
        area: nominal [m^2].
        way: slid [m].
    """

    lower: NDArray[np.int64]
    upper: NDArray[np.int64]
    interference: FloatArray
    offset: FloatArray
    lower_radius: FloatArray
    upper_radius: FloatArray
    area: float
    way: float

    def __len__(self) -> int:
        return self.interference.size


def encounters(lower: Population, upper: Population, separation: float, *, seed: int = 0) -> Encounters:
    """All asperities of two populations are laid on a square by chance, and the upper one is slid by its side.

    The square repeats, and is as large as the density of the lower surface says; that of the upper one has to say the
    same. Every pair passes once, with some offset; those that touch are returned.

    Args:
        lower: asperities of the lower surface.
        upper: of the upper one.
        separation: of the reference planes [m].
        seed: of the places.
    """
    number(separation, "separation")
    side = math.sqrt(lower.count / lower.density)
    if abs(upper.density * side**2 / upper.count - 1.0) > _ROUNDING:
        raise InputError(
            f"{lower.count} asperities of the lower surface lie on {side**2:.4g} m2, and on that the upper one has "
            f"{upper.density * side**2:.6g}, not {upper.count}; allowed: samples of the same area"
        )
    random = np.random.default_rng(seed)
    across = random.uniform(0.0, side, upper.count)[None, :] - random.uniform(0.0, side, lower.count)[:, None]
    offset = across - side * np.round(across / side)
    interference = lower.heights[:, None] + upper.heights[None, :] - separation
    total = lower.radii[:, None] + upper.radii[None, :]
    touch = (interference > 0.0) & (np.abs(offset) < reach(np.maximum(interference, 0.0), total))
    i, j = np.nonzero(touch)
    return Encounters(i, j, interference[touch], offset[touch], lower.radii[i], upper.radii[j], side**2, side)
