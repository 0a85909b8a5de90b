# SPDX-License-Identifier: BSD-3-Clause
"""Fields on a plane, ready to be drawn: the bodies that the plane cuts, the positions of their cells, the window."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import numpy as np
from matplotlib.colors import Normalize
from numpy.typing import NDArray

from brinell.plot.cells import contact_edge, contact_pieces, extent
from brinell.plot.planes import Plane, on_plane
from brinell.plot.quantities import QUANTITIES, Quantity
from brinell.plot.scales import Scales
from brinell.plot.states import Side, both_sides
from brinell.results import ContactFields, Run, RunError, Snapshot
from brinell.results.snapshots import how_to_store

__all__ = [
    "Cut",
    "Panel",
    "Window",
    "contact_on",
    "cut_of",
    "from_contact",
    "has_section",
    "panel_of",
    "round_contact",
    "usual_quantities",
    "window_of",
]

FloatArray = NDArray[np.float64]
Origin = Callable[[Side], float]
"""Where x is counted from on a body [m]."""

_RIGID_SHARE = 0.15  # height of its strip, over the depth drawn of the other body


@dataclass(frozen=True, eq=False)
class Cut:
    """One body on a plane."""

    side: Side
    across: FloatArray
    """Cell centres from left to right [m]."""
    upward: FloatArray
    """Cell centres along the sheet's other direction; a body's depth counts down or, of the upper one, up [m]."""
    values: FloatArray
    """[upward][across], SI."""


@dataclass(frozen=True, eq=False)
class Panel:
    """One field on a plane."""

    title: str
    label: str
    colour_map: str
    norm: Normalize
    unit: float
    """Scale by which the values are divided."""
    cuts: list[Cut]


@dataclass(frozen=True)
class Window:
    """Part of the plane that is drawn [m]."""

    across: tuple[float, float]
    upward: tuple[float, float]

    @property
    def shape(self) -> float:
        """Ratio of height to width."""
        return (self.upward[1] - self.upward[0]) / (self.across[1] - self.across[0])

    def within(self, panels: Sequence[Panel]) -> Window:
        """The window as far as there are cells."""
        edges = [extent(cut.across, np.abs(cut.upward), 1.0)[:2] for panel in panels for cut in panel.cuts]
        low, high = min(left for left, _ in edges), max(right for _, right in edges)
        return replace(self, across=(max(self.across[0], low), min(self.across[1], high)))


def from_contact(snapshot: Snapshot) -> Origin:
    """Whether x is counted from the centre of contact; after contact, from the origin of each body."""
    return (lambda side: side.body.contact_x) if snapshot.in_contact else (lambda _: 0.0)


def cut_of(side: Side, quantity: Quantity, plane: Plane, origin: Origin) -> Cut | None:
    """A field of one body on a plane; None if it has no such field, or does not reach the plane."""
    body, values = side.body, quantity.values(side.body)
    if values is None:
        return None
    coordinates = {"x": body.x - origin(side), "y": body.y, "z": body.z}
    on = on_plane(coordinates[plane.axis], values, plane)
    if on is None:
        return None
    across = coordinates["y" if plane.axis == "x" else "x"]
    upward = body.y if plane.axis == "z" else side.up * body.z
    return Cut(side, across, upward, on)


def round_contact(cut: Cut) -> Cut:
    """A cut of a period along x, turned round so that it has the centre of contact in the middle."""
    step = float(cut.across[1] - cut.across[0]) if cut.across.size > 1 else 1.0
    period = step * cut.across.size
    places = (cut.across + 0.5 * period) % period - 0.5 * period
    order = np.argsort(places)
    return replace(cut, across=places[order], values=cut.values[:, order])


def usual_quantities(bodies: Sequence[Side]) -> list[Quantity]:
    """Von Mises stress and plastic strain if they are not zero; at least one of them."""

    def is_there(name: str) -> bool:
        found = [QUANTITIES[name].values(side.body) for side in bodies]
        return any(values is not None and bool(np.any(values)) for values in found)

    names = ("von_mises_stress", "equivalent_plastic_strain")
    stored = [name for name in names if any(QUANTITIES[name].values(side.body) is not None for side in bodies)]
    shown = [name for name in names if is_there(name)] or (stored or list(names))[-1:]
    return [QUANTITIES[name] for name in shown]


def has_section(bodies: Sequence[Side]) -> bool:
    """Whether a field within the bodies that a section shows unasked is stored."""
    names = ("von_mises_stress", "equivalent_plastic_strain")
    return any(QUANTITIES[name].values(side.body) is not None for side in bodies for name in names)


def panel_of(
    run: Run, snapshot: Snapshot, bodies: Sequence[Side], quantity: Quantity, plane: Plane, origin: Origin
) -> Panel:
    """A field of the bodies on a plane, with a colour range that suits its values.

    Raises:
        RunError: the field is not stored, or the plane lies outside the grids.
    """
    if all(quantity.values(side.body) is None for side in bodies):
        raise RunError(
            f"{run.path}: {quantity.name} is not stored at step {snapshot.step}{how_to_store(quantity.name)}"
        )
    found = [cut_of(side, quantity, plane, origin) for side in bodies]
    cuts = [cut for cut in found if cut is not None]
    if not cuts:
        raise RunError(f"{run.path}: the plane {plane.axis} = {plane.value:g} m lies outside the grids of the bodies")
    lowest = min(float(cut.values.min()) for cut in cuts)
    highest = max(float(cut.values.max()) for cut in cuts)
    title = quantity.title_in(in_contact=snapshot.in_contact)
    return panel_over(Scales(run), quantity, title, cuts, lowest, highest)


def panel_over(scales: Scales, quantity: Quantity, title: str, cuts: list[Cut], lowest: float, highest: float) -> Panel:
    """Cuts with the colours of a given range [SI]."""
    scale = quantity.scale(scales, max(-lowest, highest))
    colour_map, norm = quantity.colours(lowest / scale.size, highest / scale.size)
    return Panel(title, scale.label("", quantity.symbol), colour_map, norm, scale.size, cuts)


def contact_on(contact: ContactFields, plane: Plane) -> list[tuple[float, float]]:
    """First and last place of each piece of the contact on a plane normal to the surface [m]; none if it misses it."""
    return contact_pieces(contact, "x" if plane.axis == "y" else "y", plane.value)


def _patch(contact: ContactFields, axis: str) -> tuple[float, float]:
    """First and last place of the contact along x or y [m]."""
    touching = contact_edge(contact) > 0.0
    coordinates = contact.x if axis == "x" else contact.y
    places = coordinates[np.any(touching, axis=0 if axis == "x" else 1)]
    half = 0.5 * (coordinates[1] - coordinates[0])
    return float(places.min()) - half, float(places.max()) + half


def window_of(
    snapshot: Snapshot,
    bodies: Sequence[Side],
    plane: Plane,
    origin: Origin,
    goes_round: tuple[bool, bool] = (False, False),
) -> Window:
    """Part of a plane to be drawn: around the contact, or around all cells that have yielded.

    Args:
        snapshot: the state.
        bodies: those that are drawn.
        plane: which one.
        origin: where x is counted from.
        goes_round: whether the bodies are periodic along x and y; without contact, all of a period is drawn.
    """
    across = "y" if plane.axis == "x" else "x"
    low, high, deep = np.inf, -np.inf, 0.0
    if snapshot.in_contact:
        pieces = [] if plane.axis == "z" else contact_on(snapshot.contact, plane)
        if pieces:
            start, end = pieces[0][0], pieces[-1][1]
        else:  # the plane passes beside the contact
            start, end = _patch(snapshot.contact, across)
        centre, reach = 0.5 * (start + end), 0.5 * (end - start)
        low, high, deep = centre - 2.0 * reach, centre + 2.0 * reach, 1.2 * reach
    cuts: list[Cut | None] = []
    for name in ("equivalent_plastic_strain", "von_mises_stress", "temperature", *QUANTITIES):  # whatever is stored
        cuts = [cut_of(side, QUANTITIES[name], plane, origin) for side in bodies]
        if any(cuts):
            break
    for cut in (cut for cut in cuts if cut is not None):
        x, z = _plastic_zone(cut)
        if z.size == 0:
            continue
        deep = max(deep, 1.15 * float(np.abs(z).max()))
        if not snapshot.in_contact and not goes_round[1 if across == "y" else 0]:
            margin = 0.1 * float(x.max() - x.min())
            low, high = min(low, float(x.min()) - margin), max(high, float(x.max()) + margin)
    edges = [extent(cut.across, np.abs(cut.upward), 1.0) for cut in cuts if cut is not None]
    left, right = min(e[0] for e in edges), max(e[1] for e in edges)
    bottom = max(max(e[2:]) for e in edges)
    if not low < high:
        low, high = left, right
    is_period = plane.axis == "z" and goes_round[1] and not snapshot.in_contact
    deep = min(bottom, deep) if deep > 0.0 and not is_period else bottom
    return Window((max(left, low), min(right, high)), _upward(snapshot, bodies, plane, deep))


def _upward(snapshot: Snapshot, bodies: Sequence[Side], plane: Plane, deep: float) -> tuple[float, float]:
    """Limits of the vertical axis with the surfaces at 0; a rigid body in contact gets a strip."""
    if plane.axis == "z":
        return -deep, deep
    drawn = {side.up for side in bodies}
    rigid = {side.up for side in both_sides(snapshot) if side.body.is_rigid and snapshot.in_contact}
    down, up = (deep if sign in drawn else _RIGID_SHARE * deep if sign in rigid else 0.0 for sign in (-1.0, 1.0))
    return -down, up


def _plastic_zone(cut: Cut) -> tuple[FloatArray, FloatArray]:
    """Places of cells that have more than a hundredth of the largest plastic strain of the body [m]."""
    body = cut.side.body
    if not body.has_yielded:
        return np.empty(0), np.empty(0)
    largest = float(body.equivalent_plastic_strain.max(initial=0.0))
    plastic = cut.values > max(1e-2 * largest, 1e-300)
    return cut.across[np.any(plastic, axis=0)], cut.upward[np.any(plastic, axis=1)]
