# SPDX-License-Identifier: BSD-3-Clause
"""Contact patches of stored states."""

from __future__ import annotations

from brinell.contact import Patches, patches
from brinell.halfspace import SurfaceGrid
from brinell.results.snapshots import ContactFields

__all__ = ["patches_of"]

_PERIODIC_ALONG = {"open": "", "periodic_x": "x", "periodic_y": "y", "periodic": "xy"}


def patches_of(contact: ContactFields, cell: tuple[float, float], boundary: str, contact_modulus: float) -> Patches:
    """Contact patches of one state.

    Args:
        contact: contact fields of the state.
        cell: cell sizes dx, dy [m].
        boundary: value of grid.boundary of the case.
        contact_modulus: contact modulus E' of the pair [Pa].
    """
    along = _PERIODIC_ALONG[boundary]
    ends = tuple("periodic" if axis in along else "open" for axis in "xy")
    ny, nx = contact.pressure.shape
    grid = SurfaceGrid(nx, ny, *cell, boundary=(ends[0], ends[1]))
    return patches(grid, contact.pressure, contact.gap, contact_modulus)
