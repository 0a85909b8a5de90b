# SPDX-License-Identifier: BSD-3-Clause
"""Tractions on the interfaces between the layers of a coated body, which decide whether a coat peels or shears off."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import accumulate
from typing import Any

import numpy as np
from numpy.typing import NDArray

from brinell.results.snapshots import BodyFields

__all__ = ["Interface", "depths_of_interfaces", "interfaces_in"]

FloatArray = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Interface:
    """Tractions on one interface of a body in one state, at the cells of its surface; (ny, nx) arrays.

    The cells of a run end at the interfaces and have values in their centres. The tractions, which are the same on both
    sides of an interface, are extrapolated linearly to it from the two cells on each side, and the mean is taken.
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
    """Tractions on the interfaces at these depths that lie between stored layers of cells.

    Raises:
        KeyError: the stress of the body is not stored.
    """
    dz = float(body.z[1] - body.z[0]) if len(body.z) > 1 else 0.0
    top = float(body.z[0]) - 0.5 * dz if dz else 0.0
    found = []
    for depth in depths:
        below = round((depth - top) / dz) if dz else 0
        if not 0 < below < len(body.z):
            continue
        sides = [_from_both_sides(body.stress[name], below) for name in ("xz", "yz", "zz")]
        difference = max(float(np.max(np.abs(above - under))) for above, under in sides)
        xz, yz, zz = (0.5 * (above + under) for above, under in sides)
        found.append(Interface(depth, body.x, body.y, xz, yz, zz, difference))
    return found


def _from_both_sides(stress: FloatArray, below: int) -> tuple[FloatArray, FloatArray]:
    """A component extrapolated from above and from below to the upper face of a layer of cells."""
    first = max(below - 2, 0)
    last = min(below + 1, len(stress) - 1)
    above = stress[below - 1] + 0.5 * (stress[below - 1] - stress[first])
    return above, stress[below] + 0.5 * (stress[below] - stress[last])
