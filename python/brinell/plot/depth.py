# SPDX-License-Identifier: BSD-3-Clause
"""Stress and plastic strain over the depth under one point of a body, as X-ray diffraction measures in layers."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from numpy.typing import NDArray

from brinell.plot import style
from brinell.plot.interfaces import mark_interfaces
from brinell.plot.overlay import largest, looks, zero_line
from brinell.plot.planes import Plane, on_plane
from brinell.plot.quantities import QUANTITIES, Quantity
from brinell.plot.scales import PERCENT, Scale, Scales, si, twin_axis
from brinell.plot.states import Bodies, Side, chosen_sides, state_title
from brinell.plot.where import usual_place
from brinell.results import Run, RunError, Snapshot
from brinell.results.snapshots import how_to_store

__all__ = ["stress_over_depth"]

FloatArray = NDArray[np.float64]

_COMPONENTS = ("stress_xx", "stress_yy", "stress_zz")


@style.figure
def stress_over_depth(
    run: Run,
    snapshot: Snapshot | None = None,
    *,
    x: float | None = None,
    y: float | None = None,
    bodies: Bodies = "both",
    ax: style.Target | None = None,
) -> Figure:
    """Normal stresses and equivalent plastic strain over the depth under one point; interfaces of layers are dashed.

    Args:
        run: where the scales come from.
        snapshot: the state, with tensors; the final one by default, whose stress is residual.
        x: of the point on each body [m]; while the bodies touch, from the centre of contact. Without x and y: 0, 0, or
            where the largest plastic strain is if nothing has yielded under 0, 0.
        y: of the point [m].
        bodies: "both", "lower" or "upper"; those without stress and strain are left out.

    Raises:
        RunError: the stress is not stored, the point lies outside the grids, or the body is rigid.
    """
    state = snapshot if snapshot is not None else run.snapshot("final", tensors=True)
    chosen = chosen_sides(run, state, bodies)
    with_stress = [side for side in chosen if any(np.any(one) for one in side.body.stress.values())]
    if not with_stress:
        how = "" if any(side.body.stress for side in chosen) else how_to_store("stress")
        raise RunError(f"{run.path}: no stress components are stored at step {state.step}, or they vanish{how}")
    if x is None and y is None:
        x, y = usual_place(state)
    x, y = x or 0.0, y or 0.0
    lines = {side.name: _lines(run, state, side, x, y) for side in with_stress}
    depth = si(largest(side.body.z for side in with_stress), "m")
    stress = si(largest(one[name] for one in lines.values() for name in _COMPONENTS), "Pa")
    fig = style.new_figure(4.4 * (1 + len(with_stress)) + 1.0, 3.9)
    *panels, last = fig.subplots(1, 1 + len(with_stress), sharex=True)
    for ax, side in zip(panels, with_stress, strict=True):
        _draw_stress(ax, side, lines[side.name], depth, stress)
        mark_interfaces(ax, run, side, depth.size)
        ax.sharey(panels[0])
        ax.set_title(f"{'stress' if state.in_contact else 'residual stress'}, {side.name}")
    for side in with_stress:
        strain = lines[side.name]["equivalent_plastic_strain"] / PERCENT.size
        mark_interfaces(last, run, side, depth.size)
        last.plot(side.body.z / depth.size, strain, color=side.colour, linestyle=side.dash, label=side.name)
    last.set_title("equivalent plastic strain")
    if len(with_stress) > 1:
        last.legend()
    _name_axes(run, panels, last, depth, stress)
    place = _place(x, y, from_contact=state.in_contact)
    fig.suptitle(f"Under {place}:  {state_title(run, state)}", fontsize=style.font(10))
    return fig


def _place(x: float, y: float, *, from_contact: bool) -> str:
    prime = "'" if from_contact else ""
    x_text, y_text = (style.quantity(value, "m") if value else "0" for value in (x, y))
    return f"$x{prime}$ = {x_text}, $y{prime}$ = {y_text}"


def _lines(run: Run, state: Snapshot, side: Side, x: float, y: float) -> dict[str, FloatArray]:
    """Values of each field over the layers of a body, in SI."""
    names = (*_COMPONENTS, "equivalent_plastic_strain")
    return {
        name: _line(run, side, QUANTITIES[name], x + (side.body.contact_x if state.in_contact else 0.0), y)
        for name in names
    }


def _line(run: Run, side: Side, quantity: Quantity, x: float, y: float) -> FloatArray:
    """Values of a field under a point, linear between the columns of cells."""
    values = quantity.values(side.body)
    if values is None:
        raise RunError(f"{run.path}: {quantity.name} of the {side.name} is not stored{how_to_store(quantity.name)}")
    plane = on_plane(side.body.y, values, Plane("y", y))
    column = on_plane(side.body.x, plane[:, None, :], Plane("x", x)) if plane is not None else None
    if column is None:
        raise RunError(f"{run.path}: the point x = {x:g} m, y = {y:g} m lies outside the grid of the {side.name}")
    return np.asarray(column[:, 0], dtype=np.float64)


def _draw_stress(ax: Axes, side: Side, lines: dict[str, FloatArray], depth: Scale, stress: Scale) -> None:
    zero_line(ax)
    for name, look in zip(_COMPONENTS, looks([f"${QUANTITIES[name].symbol}$" for name in _COMPONENTS]), strict=True):
        ax.plot(side.body.z / depth.size, lines[name] / stress.size, **look)
    ax.legend(handlelength=2.4)


def _name_axes(run: Run, panels: Sequence[Axes], last: Axes, depth: Scale, stress: Scale) -> None:
    scales = Scales(run)
    last.set_xlim(left=0.0)
    last.set_ylim(bottom=0.0)
    last.set_ylabel(PERCENT.label("", r"\varepsilon^p_\mathrm{eq}"))
    panels[0].set_ylabel(stress.label("", r"\sigma"))
    twin_axis(panels[-1], "y", stress, scales.stress(0.0), r"\sigma")
    for ax in (*panels, last):
        ax.set_xlabel(depth.label("depth", "z"))
        twin_axis(ax, "x", depth, scales.length(0.0), "z")
