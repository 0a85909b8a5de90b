# SPDX-License-Identifier: BSD-3-Clause
"""Geometry of two passing spheres, and the units in which the results do not depend on their size.

If the material has no length scale, the results in units of the critical values of the pair depend only on the
interference alpha/alpha_c and on the ratio of the radii.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

__all__ = ["QUANTITIES", "Quantity", "UnitRadius", "closest", "reach"]

FloatArray = NDArray[np.float64]


def closest(interference: ArrayLike, offset: ArrayLike, radius_sum: ArrayLike) -> tuple[FloatArray, FloatArray]:
    """Largest interference along the line of centres of a pass with an offset, and the tilt of that line.

    They are S - hypot(S - alpha, y) and atan(y/(S - alpha)) with S = R1 + R2, exact for spheres.

    Args:
        interference: overlap alpha of the tops in height [m].
        offset: distance y of the centres across the motion [m].
        radius_sum: S = R1 + R2 [m].

    Returns:
        Interference along the line of centres [m], not above 0 where the spheres never touch; tilt [rad].
    """
    alpha, y, total = np.broadcast_arrays(
        *(np.asarray(value, dtype=np.float64) for value in (interference, offset, radius_sum))
    )
    # This form avoids the difference of two large numbers.
    left = (alpha * (2.0 * total - alpha) - y**2) / (total + np.hypot(total - alpha, y))
    return left, np.arctan2(y, total - alpha)


def reach(interference: ArrayLike, radius_sum: ArrayLike) -> FloatArray:
    """Largest offset at which the spheres touch, sqrt(alpha (2 S - alpha)) [m]; 0 without interference."""
    alpha, total = np.asarray(interference, dtype=np.float64), np.asarray(radius_sum, dtype=np.float64)
    return np.asarray(np.sqrt(np.maximum(0.0, alpha * (2.0 * total - alpha))))


@dataclass(frozen=True)
class UnitRadius:
    """Critical values of a material pair, scaled by powers of the equivalent radius R = 1/(1/R1 + 1/R2).

    Attributes:
        interference: alpha_c/R [-].
        load: P_c/R^2 [Pa].
        contact_radius: a_c/R [-].
        modulus: E' [Pa].
    """

    interference: float
    load: float
    contact_radius: float
    modulus: float


@dataclass(frozen=True)
class Quantity:
    """A result of one pass of two asperities, with its natural unit.

    The natural unit is P_c^i alpha_c^j a_c^k L^l with L = sqrt(2 (R1 + R2) alpha_c), half the sliding distance in
    contact of two spheres with the interference alpha_c. In this unit the result of elastic spheres is a constant times
    (alpha/alpha_c)^power.
    """

    name: str
    si: str
    """SI unit."""
    power: float
    """Exponent of alpha/alpha_c for elastic spheres [-]."""
    units: tuple[int, int, int, int]
    """Exponents (i, j, k, l) of the natural unit."""
    text: str
    """Description."""
    adds_up: bool = True
    """Whether a sum over encounters is meaningful; peak values cannot be summed."""

    def unit(self, pair: UnitRadius, lower: ArrayLike, upper: ArrayLike) -> FloatArray:
        """Natural unit in SI units, for the radii `lower` and `upper` [m]."""
        R1, R2 = np.asarray(lower, dtype=np.float64), np.asarray(upper, dtype=np.float64)
        R = R1 * R2 / (R1 + R2)
        alpha = pair.interference * R
        i, j, k, last = self.units
        length = np.sqrt(2.0 * (R1 + R2) * alpha)
        return np.asarray((pair.load * R**2) ** i * alpha**j * (pair.contact_radius * R) ** k * length**last)


QUANTITIES = {
    quantity.name: quantity
    for quantity in (
        Quantity("work", "J", 2.0, (1, 0, 0, 1), "integral of F_X along the pass: the work of the drive"),
        Quantity("normal", "N m", 2.0, (1, 0, 0, 1), "integral of F_Z along the pass"),
        Quantity(
            "dissipation", "J", 2.0, (1, 0, 0, 1), "plastic work in both bodies, and heat of friction between them"
        ),
        Quantity("locked_in", "J", 2.0, (1, 0, 0, 1), "elastic energy of the residual stresses of both bodies"),
        Quantity("area", "m3", 1.5, (0, 0, 2, 1), "integral of the contact area along the pass"),
        Quantity(
            "dent_lower", "m3", 2.0, (0, 1, 1, 1), "volume of the dent in the lower body, below its first surface"
        ),
        Quantity("dent_upper", "m3", 2.0, (0, 1, 1, 1), "the same of the upper body"),
        Quantity("depth_lower", "m", 1.0, (0, 1, 0, 0), "depth of the dent in the lower body", adds_up=False),
        Quantity("depth_upper", "m", 1.0, (0, 1, 0, 0), "the same of the upper body", adds_up=False),
        Quantity("peak_F_X", "N", 2.0, (1, 0, 0, 0), "largest F_X", adds_up=False),
        Quantity("peak_F_Z", "N", 1.5, (1, 0, 0, 0), "largest F_Z", adds_up=False),
    )
}
"""Quantities by name."""
