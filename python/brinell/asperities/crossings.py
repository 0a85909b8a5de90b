# SPDX-License-Identifier: BSD-3-Clause
"""Integrals of a map over the offset between two passing asperities.

If asperities are distributed at random, the offset y between two asperities that meet is uniformly distributed. A pair
therefore contributes J = integral of the quantity over y. In units of the pair (`pairs`), J is again a function of
alpha/alpha_c and of the ratio of the radii, which grows about as (alpha/alpha_c)^(power + 1/2); it is tabulated.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from brinell.asperities.pairs import QUANTITIES, closest, reach
from brinell.asperities.tugging_map import AsperityMap, turned

__all__ = ["ADDED", "Crossing", "CrossingTable"]

FloatArray = NDArray[np.float64]

ADDED = tuple(name for name, quantity in QUANTITIES.items() if quantity.adds_up)
"""Names of the quantities that can be summed over encounters."""
_SQUARES = (("work", "work"), ("normal", "normal"), ("work", "normal"))
"""Products of quantities whose integrals are needed for the scatter of a finite sliding distance."""
_BEYOND = 100.0
"""Largest interference of the table over that of the map; between both the map is extrapolated, beyond it the scaled
values are constant."""
_POINTS = 400
_GAUSS = 48


@dataclass(frozen=True)
class Crossing:
    """Integral of a quantity over the offset for each pair, and its mesh and interpolation errors, in SI units."""

    value: FloatArray
    mesh: FloatArray
    interpolation: FloatArray


class CrossingTable:
    """Table of the integrals of a map over the interference, at each of its ratios of radii."""

    def __init__(self, of: AsperityMap):
        """Computes the table.

        Args:
            of: the map.
        """
        self._map = of
        low, high = of.interferences[0], of.interferences[-1]
        self._log = np.linspace(np.log(low), np.log(_BEYOND * high), _POINTS)
        parts = [self._at_ratio(float(ratio)) for ratio in of.ratios]
        self._values = {key: np.stack([part[key] for part in parts]) for key in parts[0]}

    def of_pairs(self, quantity: str, interference: FloatArray, lower: FloatArray, upper: FloatArray) -> Crossing:
        """Integrals of a quantity for pairs, zero where they do not touch.

        Args:
            quantity: name of the quantity.
            interference: interference in height of each pair [m].
            lower: radius of each lower asperity [m].
            upper: radius of each upper asperity [m].
        """
        unit, power, a, ratio = self._scales(quantity, interference, lower, upper)
        scale = unit * np.maximum(a, 0.0) ** (power + 0.5)
        value, mesh, between = (
            self._read(self._values[quantity, kind], a, ratio) * scale for kind in ("value", "mesh", "interpolation")
        )
        return Crossing(value, mesh, between)

    def of_products(
        self, product: tuple[str, str], interference: FloatArray, lower: FloatArray, upper: FloatArray
    ) -> FloatArray:
        """Integrals of the product of two quantities of a pass; the other arguments are those of `of_pairs`."""
        unit, power, a, ratio = self._scales(product[0], interference, lower, upper)
        other = QUANTITIES[product[1]]
        scale = unit * other.unit(self._map.pair, lower, upper) * np.maximum(a, 0.0) ** (power + other.power + 0.5)
        return self._read(self._values[product[0], product[1]], a, ratio) * scale

    def _scales(
        self, name: str, interference: FloatArray, lower: FloatArray, upper: FloatArray
    ) -> tuple[FloatArray, float, FloatArray, FloatArray]:
        quantity, pair = QUANTITIES[name], self._map.pair
        radius = lower * upper / (lower + upper)
        a = interference / (pair.interference * radius)
        length = np.sqrt(2.0 * (lower + upper) * pair.interference * radius)
        return quantity.unit(pair, lower, upper) * length, quantity.power, a, lower / upper

    def _read(self, rows: FloatArray, a: FloatArray, ratio: FloatArray) -> FloatArray:
        x = np.log(
            np.maximum(a, np.exp(self._log[0]))
        )  # below the table the pairs are elastic, and the scaled value is constant
        return self._map.between_ratios([np.interp(x, self._log, row) for row in rows], ratio)

    def _at_ratio(self, ratio: float) -> dict[tuple[str, str], FloatArray]:
        """Tabulated integrals at one ratio of radii, divided by (alpha/alpha_c)^(power + 1/2)."""
        alpha_c = self._map.pair.interference  # of an equivalent radius of 1
        lower, upper = 1.0 + ratio, (1.0 + ratio) / ratio
        total = lower + upper
        a = np.exp(self._log)
        t, weight = np.polynomial.legendre.leggauss(_GAUSS)
        t = 0.5 * (t + 1.0)  # half of the symmetric interval, counted twice: the weights are unchanged
        widest = reach(a * alpha_c, total)
        left, tilt = closest((a * alpha_c)[:, None], widest[:, None] * t, total)
        over_y = widest[:, None] * weight / np.sqrt(2.0 * total * alpha_c)
        result: dict[tuple[str, str], FloatArray] = {}
        of_offset = {}
        for name in ADDED:
            found = self._map.scaled(name, left / alpha_c, ratio)
            turn = turned(name, tilt)
            of_offset[name] = found.value * turn
            power = a ** (QUANTITIES[name].power + 0.5)
            for kind in ("value", "mesh", "interpolation"):
                result[name, kind] = (getattr(found, kind) * turn * over_y).sum(axis=1) / power
        for one, other in _SQUARES:
            power = a ** (QUANTITIES[one].power + QUANTITIES[other].power + 0.5)
            result[one, other] = (of_offset[one] * of_offset[other] * over_y).sum(axis=1) / power
        return result
