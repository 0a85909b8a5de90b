# SPDX-License-Identifier: BSD-3-Clause
"""Where figures cut the bodies unless told: through the middle, or where they have yielded if that is elsewhere."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from brinell.plot import style
from brinell.plot.cells import middle_rows
from brinell.plot.planes import Plane
from brinell.plot.states import Side, sides
from brinell.results import BodyFields, Run, Snapshot

__all__ = ["Cutting", "cutting_of", "goes_round", "most_strained", "section_of", "usual_place"]

FloatArray = NDArray[np.float64]

_ENOUGH = 0.5
"""Of the largest value, found on y = 0: then this plane, that of symmetry of smooth bodies, shows what matters."""


@dataclass(frozen=True)
class Cutting:
    """The plane that a figure shows unasked, and why it is not y = 0."""

    plane: Plane
    reason: str
    """ "through the largest plastic strain"; empty on y = 0."""

    def text(self) -> str:
        """For captions and titles: "y = 0", "y = 34 µm (through the largest plastic strain)"."""
        place = f"{self.plane.axis} = {style.length(self.plane.value)}"
        return f"{place} ({self.reason})" if self.reason else place


def cutting_of(snapshot: Snapshot, bodies: Sequence[Side] | None = None) -> Cutting:
    """The plane y = 0, or the one through the largest plastic strain if little has yielded on y = 0.

    Where no plastic strain is stored, or nothing has yielded, the residual displacement and the pressure count instead.

    Args:
        snapshot: the state.
        bodies: those drawn; None: both.
    """
    drawn = [side.body for side in (sides(snapshot) if bodies is None else bodies)]
    strained = [(body.y, _by_row(body.equivalent_plastic_strain)) for body in drawn if body.has_yielded]
    dented = [(body.y, _by_row(body.residual_displacement)) for body in drawn if body.is_dented]
    contact = snapshot.contact
    pressed = [(contact.y, _by_row(contact.pressure))] if snapshot.in_contact else []
    for rows, what in (
        (strained, "the largest plastic strain"),
        (dented, "the largest residual displacement"),
        (pressed, "the largest pressure"),
    ):
        if rows:
            y = _place_of_largest(rows)
            return Cutting(Plane("y", y), f"through {what}" if y else "")
    return Cutting(Plane("y", 0.0), "")


def section_of(snapshot: Snapshot, bodies: Sequence[Side] | None = None) -> Cutting:
    """The plane of a section: that of `cutting_of`, or the only depth at which fields within the bodies are stored."""
    drawn = [side.body for side in (sides(snapshot) if bodies is None else bodies)]
    if drawn and all(body.z.size == 1 for body in drawn):
        return Cutting(Plane("z", float(drawn[0].z[0])), "")
    return cutting_of(snapshot, bodies)


def _by_row(values: FloatArray) -> FloatArray:
    """Largest magnitude in each row of a field [y][x] or [z][y][x]."""
    return np.asarray(np.abs(values).max(axis=tuple(axis for axis in range(values.ndim) if axis != values.ndim - 2)))


def _place_of_largest(rows: Sequence[tuple[FloatArray, FloatArray]]) -> float:
    """Place of the largest of values by row, for several bodies; 0 if enough of it lies there [m]."""
    largest = max(float(values.max()) for _, values in rows)
    if any(float(values[middle_rows(y)].max()) >= _ENOUGH * largest for y, values in rows):
        return 0.0
    y, values = max(rows, key=lambda one: float(one[1].max()))
    return float(y[int(np.argmax(values))])


def most_strained(body: BodyFields) -> tuple[int, int] | None:
    """Row and column of the cells under which the largest plastic strain is; None if it is zero or not stored."""
    if not body.has_yielded:
        return None
    strain = body.equivalent_plastic_strain
    _, row, column = np.unravel_index(int(np.argmax(strain)), strain.shape)
    return int(row), int(column)


def usual_place(state: Snapshot, x: float = 0.0) -> tuple[float, float]:
    """The point (x, 0), or the one of the largest plastic strain if no body has yielded under (x, 0) [m]."""
    found: list[tuple[float, float, float]] = []
    for side in sides(state):
        body, place = side.body, most_strained(side.body)
        shift = body.contact_x if state.in_contact else 0.0
        if place is None:
            continue
        row, column = int(np.argmin(np.abs(body.y))), int(np.argmin(np.abs(body.x - shift - x)))
        if np.any(body.equivalent_plastic_strain[:, max(row - 1, 0) : row + 2, max(column - 1, 0) : column + 2]):
            return x, 0.0
        largest_strain = float(body.equivalent_plastic_strain.max())
        found.append((largest_strain, float(body.x[place[1]] - shift), float(body.y[place[0]])))
    return max(found)[1:] if found else (x, 0.0)


def goes_round(run: Run) -> tuple[bool, bool]:
    """Whether the surfaces are periodic along x and y; of an unfinished run it is not known, so false."""
    boundary = str(run.case("grid", "boundary") or "open") if run.complete else "open"
    return boundary in ("periodic", "periodic_x"), boundary in ("periodic", "periodic_y")
