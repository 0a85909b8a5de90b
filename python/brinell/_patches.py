# SPDX-License-Identifier: BSD-3-Clause
"""Area and patches of a solved contact, of `brinell.contact`."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from brinell import _core
from brinell._arrays import Array, contiguous
from brinell.errors import InputError
from brinell.halfspace import SurfaceGrid


def _modulus(contact_modulus: float) -> float:
    if not contact_modulus > 0.0:
        raise InputError(f"contact_modulus = {contact_modulus:g}; allowed: > 0")
    return float(contact_modulus)


def contact_area(grid: SurfaceGrid, pressure: ArrayLike, gap: ArrayLike, contact_modulus: float) -> float:
    """Area of a solved contact [m^2], finer than its cells: the edge lies where pressure inside and gap outside say.

    Contact that reaches the end of the grid ends with its cells there, and so does that under a body with an edge.

    Args:
        grid: of the fields.
        pressure: (ny, nx), >= 0 [Pa].
        gap: (ny, nx) between the deformed surfaces [m].
        contact_modulus: E' of the pair [Pa].

    Raises:
        InputError: a wrong shape, or a modulus that is not above 0.
    """
    return _core.contact_area(
        grid._engine, contiguous(pressure, "pressure"), contiguous(gap, "gap"), _modulus(contact_modulus)
    )


@dataclass(frozen=True, eq=False)
class Patches:
    """The patches of a contact: cells under pressure that hang together by their sides, over the ends of a period, too.

    Attributes:
        label: (ny, nx), the number of the patch that a cell is in, from 0; -1 without pressure.
        area: of each patch, finer than its cells [m^2]; they add up to `contact_area`.
        load: of each patch [N].
        cells: of each patch.
    """

    label: NDArray[np.int64]
    area: Array
    load: Array
    cells: NDArray[np.int64]

    def __len__(self) -> int:
        return len(self.area)

    def __repr__(self) -> str:
        return f"<Patches {len(self)}, together {self.area.sum():g} m^2>"


def patches(grid: SurfaceGrid, pressure: ArrayLike, gap: ArrayLike, contact_modulus: float) -> Patches:
    """The patches of a solved contact.

    Args:
        grid: of the fields; where it is periodic, patches go on over its ends.
        pressure: (ny, nx), >= 0 [Pa].
        gap: (ny, nx) between the deformed surfaces [m].
        contact_modulus: E' of the pair [Pa].

    Raises:
        InputError: a wrong shape, or a modulus that is not above 0.
    """
    p = contiguous(pressure, "pressure")
    labels, area = _core.patches(grid._engine, p, contiguous(gap, "gap"), _modulus(contact_modulus))
    label = labels.astype(np.int64)
    inside = label >= 0
    cells = np.bincount(label[inside], minlength=len(area))
    sums = np.bincount(label[inside], weights=p[inside], minlength=len(area))
    load = np.asarray(sums * grid.dx * grid.dy, dtype=np.float64)
    return Patches(label, area, load, cells)
