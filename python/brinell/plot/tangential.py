# SPDX-License-Identifier: BSD-3-Clause
"""Shear and slip along the surface in one state, and the parts of figures that show them.

SI. The shear is that on the lower body, the slip that of the upper surface over the lower one since the start; in
rolling, since these places came under the contact.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from matplotlib.axes import Axes
from matplotlib.colors import Normalize
from matplotlib.image import AxesImage
from numpy.typing import NDArray

from brinell.plot.cells import contact_edge, contact_patch, extent, refined
from brinell.plot.scales import Scale
from brinell.plot.states import Which
from brinell.results import ContactFields, Run, RunError, Snapshot

__all__ = [
    "SLIP",
    "STICK",
    "BoolArray",
    "FloatArray",
    "Tangential",
    "draw_field",
    "draw_outline",
    "draw_size",
    "extended",
    "has_slip",
    "map_size",
    "shade_sticking",
    "since",
    "state_with_slip",
    "stick_edge",
    "sticks",
    "tangential",
]

FloatArray = NDArray[np.float64]
BoolArray = NDArray[np.bool_]
Component = FloatArray | None

_BOUND = 1.0 - 1e-12
"""Share of friction times pressure above which a shear counts as slipping."""
STICK, SLIP = "#56B4E9", "#F6DDB0"  # Okabe-Ito sky blue, and a tint of its orange


@dataclass(frozen=True, eq=False)
class Tangential:
    """Shear and slip along the surface in a state in which the bodies touch; arrays [y][x]."""

    contact: ContactFields
    bound: FloatArray
    """Friction times pressure [Pa]."""
    shear: tuple[FloatArray, FloatArray]
    """Along x and y [Pa]."""
    slip: tuple[FloatArray, FloatArray]
    """[m]."""
    direction: tuple[float, float]
    """Unit vector of the motion."""
    sticking: BoolArray

    @property
    def shear_size(self) -> FloatArray:
        """Magnitude of the shear [Pa]."""
        return np.hypot(*self.shear)

    @property
    def slip_size(self) -> FloatArray:
        """Magnitude of the slip [m], continued into the cells around the contact, because it is largest at the edge."""
        touching = self.contact.pressure > 0.0
        return extended(np.hypot(*self.slip), touching)

    def along(self, vector: tuple[FloatArray, FloatArray]) -> FloatArray:
        """Component of a vector field along the motion."""
        return vector[0] * self.direction[0] + vector[1] * self.direction[1]


def since(runs: Sequence[Run]) -> str:
    """Words for the time from which slip counts; where the contact moves, each place has a time of its own."""
    return "the start" if all(run.scenario == "fretting" for run in runs) else "these places touched"


def has_slip(snapshot: Snapshot) -> bool:
    """Whether the bodies touch, and shears and slips are stored."""
    contact = snapshot.contact
    return snapshot.in_contact and contact.shear_x is not None and contact.slip_x is not None


def state_with_slip(run: Run, which: Which) -> Snapshot | None:
    """A stored state with shears and slips; None if there is none."""
    if which == "aligned" and not run.steps:
        return None
    snapshot = run.snapshot(which)
    return snapshot if has_slip(snapshot) else None


def sticks(contact: ContactFields, bound: FloatArray) -> BoolArray:
    """Cells under pressure whose shear is below its bound [Pa]; without a shear all of them."""
    return np.asarray((contact.pressure > 0.0) & (_shear_size(contact) < _BOUND * bound))


def _shear_size(contact: ContactFields) -> FloatArray:
    zero = np.zeros_like(contact.pressure)
    return np.hypot(*(zero if one is None else one for one in (contact.shear_x, contact.shear_y)))


def tangential(run: Run, snapshot: Snapshot) -> Tangential:
    """Shear and slip of a state.

    Raises:
        RunError: the bodies do not touch in this state, or no shear is stored.
    """
    if not has_slip(snapshot):
        raise RunError(f"{run.path}: no shear and slip in the state at step {snapshot.step}, so nothing to draw")
    contact = snapshot.contact

    def field(values: Component) -> FloatArray:
        return np.zeros_like(contact.pressure) if values is None else values

    angle = np.radians(float(run.case("fretting", "direction") or 0.0)) if run.complete else 0.0
    friction = float(run.case("interface", "friction") or 0.0)
    return Tangential(
        contact,
        friction * contact.pressure,
        (field(contact.shear_x), field(contact.shear_y)),
        (field(contact.slip_x), field(contact.slip_y)),
        (float(np.cos(angle)), float(np.sin(angle))),
        _sticking(snapshot, friction * contact.pressure),
    )


def _sticking(snapshot: Snapshot, bound: FloatArray) -> BoolArray:
    """Cells that stick; their share is the one in the history.

    A surface that yields carries less than friction times pressure, by a limit that is not stored. Therefore of the
    cells below this bound those with the largest shear count as slipping until the share fits.
    """
    contact = snapshot.contact
    found = sticks(contact, bound)
    told = round(snapshot.row["stick_share"] * int(np.count_nonzero(contact.pressure > 0.0)))
    surplus = int(np.count_nonzero(found)) - told
    if surplus > 0:
        size = np.where(found, _shear_size(contact), -1.0)
        found.flat[np.argsort(size, axis=None)[-surplus:]] = False
    return found


def stick_edge(state: Tangential) -> FloatArray:
    """A function whose zero line is the edge of the sticking area, positive inside [-], array [y][x].

    Near the edge the difference from the bound grows with the square root of the distance, as pressure does near the
    edge of contact, so its square is linear there. Cells that slip have no such difference: the edge is placed halfway
    to the next cell.
    """
    inside = state.sticking
    left = np.where(inside, state.bound - state.shear_size, 0.0) ** 2
    if not inside.any():
        return np.full_like(left, -1.0)
    rim = np.zeros_like(inside)
    rim[:, 1:] |= inside[:, 1:] & ~inside[:, :-1]
    rim[:, :-1] |= inside[:, :-1] & ~inside[:, 1:]
    rim[1:, :] |= inside[1:, :] & ~inside[:-1, :]
    rim[:-1, :] |= inside[:-1, :] & ~inside[1:, :]
    beyond = float(left[rim].mean()) if rim.any() else float(left.max())
    return np.asarray(np.where(inside, left, -beyond) / left.max())


def extended(values: FloatArray, where: BoolArray) -> FloatArray:
    """The values where `where` holds, the means of these neighbours in the cells beside, and 0 elsewhere."""
    inside = np.where(where, values, 0.0)
    total, count = (np.pad(one, 1) for one in (inside, where.astype(np.float64)))
    ny, nx = values.shape
    shifts = [(j, i) for j in range(3) for i in range(3)]
    sums, counts = (sum(one[j : j + ny, i : i + nx] for j, i in shifts) for one in (total, count))
    return np.asarray(np.where(where, inside, sums / np.maximum(counts, 1.0)))


def map_size(contact: ContactFields) -> tuple[float, float]:
    """Width and height of a map [inch] by the shape of the contact, so that there is no empty space beside it."""
    (left, right), (low, high) = contact_patch(contact, 1.0)
    aspect = (right - left) / (high - low)
    return max(1.3, 3.3 * min(aspect, 1.0)), max(1.1, 3.3 / max(aspect, 1.0))


def draw_field(
    ax: Axes, state: Tangential, values: FloatArray, length: Scale, scale: Scale, cmap: str, *, cells: bool
) -> AxesImage:
    """Draws a field of the contact; the surroundings are white."""
    contact = state.contact
    edge = contact_edge(contact)
    factor = 1 if cells else max(2, 600 // min(contact.pressure.shape))
    outside = contact.pressure <= 0.0 if cells else refined(edge, factor) <= 0.0
    shown = np.ma.masked_where(outside, refined(values, factor) / scale.size)
    image = ax.imshow(
        shown,
        origin="lower",
        extent=extent(contact.x, contact.y, length.size),
        cmap=cmap,
        norm=Normalize(0.0, float(values.max()) / scale.size or 1.0),
        interpolation="nearest",
    )
    if not cells:
        # Even the refined cells show as steps: cut them along the edge.
        place = (contact.x / length.size, contact.y / length.size)
        ax.contourf(*place, edge, levels=[edge.min() - 1.0, 0.0], colors="white")
        draw_outline(ax, state, edge, length, "black")
    return image


def draw_outline(ax: Axes, state: Tangential, level: FloatArray, length: Scale, colour: str) -> None:
    """Draws the zero line of a function on the cells."""
    if level.min() < 0.0 < level.max():
        place = (state.contact.x / length.size, state.contact.y / length.size)
        ax.contour(*place, level, levels=[0.0], colors=colour, linewidths=1.0)


def draw_size(
    ax: Axes,
    state: Tangential,
    values: FloatArray,
    length: Scale,
    scale: Scale,
    look: tuple[str, str],
    *,
    cells: bool,
    stick: str = "white",
) -> None:
    """Draws a magnitude with its colour map and label, and the edge of the sticking area in the colour `stick`."""
    image = draw_field(ax, state, values, length, scale, look[0], cells=cells)
    if not cells:
        draw_outline(ax, state, stick_edge(state), length, stick)
    ax.figure.colorbar(image, ax=ax, label=look[1], pad=0.02)


def shade_sticking(ax: Axes, place: FloatArray, sticking: BoolArray) -> None:
    """Shades the sticking area behind the curves, up to half a cell beyond the centres of its cells."""
    half = 0.5 * (place[1] - place[0])
    ends = np.flatnonzero(np.diff(np.concatenate([[False], sticking, [False]]).astype(int)))
    for number, (first, last) in enumerate(ends.reshape(-1, 2)):
        label = "sticks" if number == 0 else "_"
        ax.axvspan(place[first] - half, place[last - 1] + half, color=STICK, alpha=0.25, lw=0.0, zorder=0, label=label)
