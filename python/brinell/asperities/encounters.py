# SPDX-License-Identifier: BSD-3-Clause
"""Randomly placed asperities that meet one by one, as a check of the sums and a model of one experiment."""

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
    """Passes of two asperities each, with one array entry per pass.

    Attributes:
        lower: index of the lower asperity in its population.
        upper: index of the upper asperity in its population.
        interference: overlap of the tops in height [m].
        offset: distance of the upper centre from the lower one across the motion [m].
        lower_radius: radius of the lower asperity [m].
        upper_radius: radius of the upper asperity [m].
        area: nominal area [m^2].
        way: sliding distance [m].
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
    """Places all asperities of two populations at random on a periodic square and slides the upper one by its side.

    The area of the square follows from the number and density of the asperities, which must give the same area for both
    surfaces. Every pair passes once with some offset; the pairs that touch are returned.

    Args:
        lower: asperities of the lower surface.
        upper: asperities of the upper surface.
        separation: distance of the reference planes [m].
        seed: seed of the random positions.

    Raises:
        InputError: the populations are not samples of the same area.
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
