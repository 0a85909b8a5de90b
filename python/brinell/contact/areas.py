# SPDX-License-Identifier: BSD-3-Clause
"""Contact area and contact patches of a solved contact."""

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
    """Area of a solved contact [m^2] with a resolution finer than one cell.

    The position of the contact edge is estimated from the pressure inside and the gap outside. At the end of the grid,
    and under a body with a sharp edge, the area ends with the cells.

    Args:
        grid: grid of the fields.
        pressure: (ny, nx) contact pressure, >= 0 [Pa].
        gap: (ny, nx) gap between the deformed surfaces [m].
        contact_modulus: contact modulus E' of the pair [Pa].

    Raises:
        InputError: a wrong shape, or a modulus that is not above 0.
    """
    return _core.contact_area(
        grid._engine, contiguous(pressure, "pressure"), contiguous(gap, "gap"), _modulus(contact_modulus)
    )


@dataclass(frozen=True, eq=False)
class Patches:
    """Contact patches: connected sets of cells under pressure.

    Cells are connected by their sides, on periodic axes also across the ends of the grid.

    Attributes:
        label: (ny, nx) number of the patch of each cell, from 0; -1 without pressure.
        area: (patches,) area of each patch with a resolution finer than one cell [m^2]; the sum is `contact_area`.
        load: (patches,) load of each patch [N].
        cells: (patches,) number of cells of each patch.
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
    """Finds the contact patches of a solved contact.

    Args:
        grid: grid of the fields; along periodic axes patches continue across the ends.
        pressure: (ny, nx) contact pressure, >= 0 [Pa].
        gap: (ny, nx) gap between the deformed surfaces [m].
        contact_modulus: contact modulus E' of the pair [Pa].

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
