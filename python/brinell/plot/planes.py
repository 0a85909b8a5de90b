# SPDX-License-Identifier: BSD-3-Clause
"""Planes through a body: their notation, and cell values on them."""

from __future__ import annotations

import re
from dataclasses import dataclass
from typing import Literal, get_args

import numpy as np
from numpy.typing import NDArray

from brinell.errors import InputError
from brinell.plot import style

__all__ = ["Axis", "Plane", "on_plane", "plane_of"]

FloatArray = NDArray[np.float64]
Axis = Literal["x", "y", "z"]

_METRES = {"": 1.0, "m": 1.0, "cm": 1e-2, "mm": 1e-3, "um": 1e-6, "µm": 1e-6, "μm": 1e-6, "nm": 1e-9}
_WRITTEN = re.compile(r"\s*([xyz])\s*=\s*([-+]?[0-9.]+(?:[eE][-+]?[0-9]+)?)\s*([a-zµμ]*)\s*")
_ARRAY_AXIS = {"x": 2, "y": 1, "z": 0}  # of a volume [z][y][x]


@dataclass(frozen=True)
class Plane:
    """A plane normal to one of the axes."""

    axis: Axis
    value: float
    """Coordinate along that axis [m]; z counts into each body, from its surface."""

    def label(self, *, from_contact: bool) -> str:
        """For a title: "$y$ = 0"; x' and y' are measured from the centre of contact."""
        prime = "'" if from_contact and self.axis != "z" else ""
        return f"${self.axis}{prime}$ = {style.quantity(self.value, 'm') if self.value else '0'}"


def plane_of(written: Plane | str | tuple[str, float]) -> Plane:
    """The plane of a notation.

    Args:
        written: "y=0", "x = 0.1 mm", "z = 20 um" (a bare number is in metres), or the pair ("z", 2e-5).

    Raises:
        InputError: it is none of these.
    """
    if isinstance(written, Plane):
        return written
    if isinstance(written, tuple):
        axis, value = written[0], float(written[1])
    else:
        found = _WRITTEN.fullmatch(written)
        if found is None or found[3] not in _METRES:
            raise InputError(f"{written!r} is not a plane; allowed: 'y=0', 'x = 0.1 mm', 'z = 20 um'")
        axis, value = found[1], float(found[2]) * _METRES[found[3]]
    for known in get_args(Axis):
        if axis == known and np.isfinite(value) and (known != "z" or value >= 0.0):
            return Plane(known, value)
    raise InputError(f"{axis} = {value:g} m is not a plane; allowed: a place along x or y, or a depth z >= 0")


def on_plane(
    coordinates: FloatArray, values: FloatArray, plane: Plane, *, at: float | None = None
) -> FloatArray | None:
    """Values of a volume [z][y][x] on a plane, linear between the cell centres; None if it lies outside the cells.

    Args:
        coordinates: of the cell centres along the plane's axis [m].
        values: by cell.
        plane: which one.
        at: where it cuts this body, if that is not the plane's own value [m].
    """
    place = plane.value if at is None else at
    half = 0.5 * (coordinates[1] - coordinates[0]) if len(coordinates) > 1 else np.inf
    if not coordinates[0] - half <= place <= coordinates[-1] + half:
        return None
    position = float(np.interp(place, coordinates, np.arange(len(coordinates))))
    left = int(position)
    right, share = min(left + 1, len(coordinates) - 1), position - left
    axis = _ARRAY_AXIS[plane.axis]
    return np.asarray((1.0 - share) * values.take(left, axis) + share * values.take(right, axis), dtype=np.float64)
