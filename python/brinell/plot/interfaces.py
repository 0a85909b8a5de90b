# SPDX-License-Identifier: BSD-3-Clause
"""Interfaces between the layers of coated bodies: where they lie, and the tractions on them."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Literal

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patheffects import withStroke
from numpy.typing import NDArray

from brinell.plot import style
from brinell.plot.cuts import Cut
from brinell.plot.overlay import Look, largest, legend_beside, looks, zero_line
from brinell.plot.scales import Scale, Scales, si
from brinell.plot.states import Side, of_state, state_title
from brinell.results import BodyFields, Interface, Run, RunError, Snapshot
from brinell.results.snapshots import how_to_store

__all__ = ["draw_interfaces", "interface_tractions", "interfaces_of", "mark_interfaces"]

FloatArray = NDArray[np.float64]
BodyName = Literal["lower", "upper"]


def interfaces_of(run: Run, side: Side) -> list[float]:
    """Depths of the interfaces of a body [m], from the surface down; empty for a homogeneous one."""
    try:
        return run.interface_depths("lower" if side.up < 0.0 else "upper")
    except RunError:  # an unfinished run may not have written its case yet
        return []


def draw_interfaces(ax: Axes, run: Run, cuts: Sequence[Cut], length: float) -> None:
    """Draws the interfaces into a section normal to the surface. `length`: size of the unit of the axes [m]."""
    for cut in cuts:
        for depth in interfaces_of(run, cut.side):
            line = ax.axhline(cut.side.up * depth / length, color="white", linewidth=0.8, linestyle="--")
            line.set_path_effects([withStroke(linewidth=1.8, foreground="0.3")])


def mark_interfaces(ax: Axes, run: Run, side: Side, depth: float) -> None:
    """Marks the interfaces on an axis of depths. `depth`: size of its unit [m]."""
    for one in interfaces_of(run, side):
        ax.axvline(one / depth, color="0.5", linewidth=0.8, linestyle="--")


@style.figure
@of_state
def interface_tractions(
    run: Run, snapshot: Snapshot, *, body: BodyName | None = None, ax: style.Target | None = None
) -> Figure | None:
    """Shear and normal traction on the interfaces of a coated body, over x on the line y = 0.

    Tension is positive and peels. Where other states are stored, dashed curves are the largest shear and the largest
    tension in any of them at each place, which matters where the contact passes. The title says how
    far the values differ that the cells on both sides give.

    Args:
        run: where the interfaces and the scales come from.
        body: "lower" or "upper"; by default the one with interfaces, the lower one of two.

    Returns:
        None if the body is the same all through, or no cells lie at its interfaces.

    Raises:
        RunError: the stress of the body is not stored.
    """
    chosen: BodyName = body or ("lower" if run.interface_depths("lower") else "upper")
    found = _interfaces(run, snapshot, chosen)
    if not found:
        return None
    fields: BodyFields = getattr(snapshot, chosen)
    stored = [_interfaces(run, run.snapshot(step), chosen) for step in run.steps]
    states = [
        state for state in stored if len(state) == len(found) and state[0].shear_x.shape == found[0].shear_x.shape
    ]
    origin = fields.contact_x if snapshot.in_contact else 0.0
    length = Scales(run).length(float(np.abs(fields.x - origin).max()))
    size = si(largest(field for one in found for field in (one.shear, one.normal)), "Pa")
    fig = style.new_figure(10.4, 3.6)
    shear, normal = fig.subplots(1, 2, sharex=True)
    named = looks([f"$z$ = {style.length(one.depth)}" for one in found])
    depth_looks = [look | {"linestyle": "-"} for look in named]  # dashes are for the largest values
    for index, (one, look) in enumerate(zip(found, depth_looks, strict=True)):
        row, x = int(np.argmin(np.abs(one.y))), (one.x - origin) / length.size
        shear.plot(x, one.shear[row] / size.size, **look)
        normal.plot(x, one.normal[row] / size.size, **look)
        if len(states) > 1:
            same = [state[index] for state in states]
            _draw_largest(shear, x, (other.shear[row] for other in same), size, look)
            _draw_largest(normal, x, (other.normal[row] for other in same), size, look)
    _name_tractions((shear, normal), (length, size), [*depth_looks, *_of_history(len(states))], snapshot)
    difference = style.quantity(max(one.difference for one in found), "Pa", 2)
    title = f"Interfaces of the {chosen} body, $y$ = 0, both sides within {difference}:  {state_title(run, snapshot)}"
    fig.suptitle(title, fontsize=style.font(10))
    return fig


def _interfaces(run: Run, snapshot: Snapshot, body: BodyName) -> list[Interface]:
    try:
        return run.interfaces(body, snapshot)
    except KeyError as error:
        where = f"{run.path}: no stress components of the {body} body are stored at step {snapshot.step}"
        raise RunError(where + how_to_store("stress")) from error


def _draw_largest(ax: Axes, x: FloatArray, lines: Iterable[FloatArray], unit: Scale, look: Look) -> None:
    """Draws the largest value over states."""
    ax.plot(
        x, np.max(list(lines), axis=0) / unit.size, **look | {"linestyle": (0, (3, 2)), "linewidth": 0.9, "label": "_"}
    )


def _of_history(states: int) -> list[Look]:
    """Entry of the legend for the curves over all states."""
    if states < 2:
        return []
    return [{"color": "0.3", "linestyle": (0, (3, 2)), "linewidth": 0.9, "label": f"largest of {states} states"}]


def _name_tractions(
    panels: tuple[Axes, Axes], scales: tuple[Scale, Scale], legend: Sequence[Look], snapshot: Snapshot
) -> None:
    """Titles, labels and legend of the tractions on interfaces."""
    (shear, normal), (length, size) = panels, scales
    from_contact = "from the centre of contact" if snapshot.in_contact else ""
    for ax in panels:
        zero_line(ax)
        ax.set_xlabel(length.label(from_contact, "x'" if snapshot.in_contact else "x"))
        ax.margins(x=0.02)
    shear.set_title("(a)  shear on the interface")
    shear.set_ylabel(size.label("", r"\tau"))
    normal.set_title("(b)  normal traction, tension positive")
    normal.set_ylabel(size.label("", r"\sigma_{zz}"))
    legend_beside(normal, legend, title="interface")
