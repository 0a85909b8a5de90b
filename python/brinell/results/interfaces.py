# SPDX-License-Identifier: BSD-3-Clause
"""Tractions on the interfaces between the layers of a coated body, which decide whether a coat peels or shears off."""

from __future__ import annotations

import math
import warnings
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import accumulate
from typing import Any

import numpy as np
from numpy.typing import NDArray

from brinell.case import ResolutionWarning
from brinell.results.snapshots import BodyFields

__all__ = ["Interface", "depths_of_interfaces", "interfaces_in"]

FloatArray = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Interface:
    """Tractions on one interface of a body in one state, at the cells of its surface; (ny, nx) arrays.

    Cells have values in their centres. The tractions, which are the same on both sides of an interface, are
    extrapolated linearly to it from the two nearest layers of cells on each side, and the mean is taken. Cells of a
    body that can yield, or whose fatigue is computed, end at the interfaces; of others, a layer of cells that contains
    an interface is left out.
    """

    depth: float
    """Of the interface in the body [m]."""
    x: FloatArray
    """(nx,) coordinates along the surface, those of the fields of the body [m]."""
    y: FloatArray
    """(ny,) coordinates across [m]."""
    shear_x: FloatArray
    """Stress xz on the interface [Pa]."""
    shear_y: FloatArray
    """Stress yz [Pa]."""
    normal: FloatArray
    """Stress zz, positive in tension, which peels [Pa]."""
    difference: float
    """Largest difference between the values from both sides, of any traction [Pa]: how well the cells resolve them."""

    @property
    def shear(self) -> FloatArray:
        """Magnitude of the shear on the interface [Pa]."""
        return np.hypot(self.shear_x, self.shear_y)

    def __repr__(self) -> str:
        return f"<Interface at {self.depth:g} m>"


def depths_of_interfaces(material: Mapping[str, Any]) -> list[float]:
    """Depths of the interfaces of a material of a computed case [m], from the surface down; none without layers."""
    layers = material.get("layers", [])
    return list(accumulate(float(layer["thickness"]) for layer in ([layers] if isinstance(layers, dict) else layers)))


def interfaces_in(body: BodyFields, depths: Sequence[float]) -> list[Interface]:
    """Tractions on the interfaces at these depths that have stored layers of cells on both sides.

    Warns:
        ResolutionWarning: an interface lies within the first layer of cells, or the last one, so that it is left out.

    Raises:
        KeyError: the stress of the body is not stored.
    """
    found = []
    for depth in depths:
        sides = _Sides.of(body.z, depth)
        if sides is None:
            continue
        pairs = [sides.extrapolated(body.stress[name]) for name in ("xz", "yz", "zz")]
        difference = max(float(np.max(np.abs(above - under))) for above, under in pairs)
        xz, yz, zz = (0.5 * (above + under) for above, under in pairs)
        found.append(Interface(depth, body.x, body.y, xz, yz, zz, difference))
    return found


@dataclass(frozen=True)
class _Sides:
    """The layers of cells next to an interface."""

    above: int
    below: int
    past: tuple[float, float]
    """From their centres to the interface, over the distance of two layers."""

    @classmethod
    def of(cls, z: FloatArray, depth: float) -> _Sides | None:
        """Finds them; None with a warning if there are none on one side."""
        if len(z) < 2:
            return None
        dz = float(z[1] - z[0])
        place = (depth - float(z[0])) / dz + 0.5  # in layers, from the upper face of the first one
        rounding = 1e-6
        above, below = math.floor(place + rounding) - 1, math.ceil(place - rounding)
        if above < 0 or below >= len(z):
            warnings.warn(
                f"the interface at {depth:g} m is left out: it lies within the first or beyond the last of the stored "
                f"layers of cells, which are {dz:g} m thick; allowed: thinner cells (grid.spacing)",
                ResolutionWarning,
                stacklevel=4,
            )
            return None
        return cls(above, below, (place - above - 0.5, below + 0.5 - place))

    def extrapolated(self, stress: FloatArray) -> tuple[FloatArray, FloatArray]:
        """A component at the interface, from above and from below."""
        first, last = max(self.above - 1, 0), min(self.below + 1, len(stress) - 1)
        above, below = stress[self.above], stress[self.below]
        return above + self.past[0] * (above - stress[first]), below + self.past[1] * (below - stress[last])
