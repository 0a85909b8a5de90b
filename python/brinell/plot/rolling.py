# SPDX-License-Identifier: BSD-3-Clause
"""Rolling: deformation by pass, residual stress and strain over depth, cross section of the track, forces along it.

SI with prefixes throughout. Heights are out of the lower body: shoulders positive. F_X is the resistance: positive
where the drive must push. Stresses are positive in tension.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Literal

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator
from numpy.typing import NDArray

from brinell.plot import style
from brinell.plot.cells import at_centre
from brinell.plot.friction_heat import friction_heat_map, has_friction_heat
from brinell.plot.overlay import (
    Entry,
    Look,
    entries,
    evenly_chosen,
    largest,
    legend_beside,
    of_runs,
    require_scenario,
    zero_line,
)
from brinell.plot.scales import PERCENT, Scale, si
from brinell.plot.slip import stick_slip_maps, stick_slip_profiles
from brinell.plot.tangential import state_with_slip
from brinell.plot.track_depth import depth_profiles
from brinell.results import BodyFields, History, Run, Snapshot

__all__ = [
    "along_track",
    "creep_forces",
    "creep_heat",
    "creep_maps",
    "creep_profiles",
    "creeps",
    "depth_profiles",
    "pass_by_pass",
    "rolled",
    "track_profile",
]

Which = int | Literal["aligned", "final"]

FloatArray = NDArray[np.float64]


def _of_passes(run: Run, name: str) -> FloatArray:
    return np.array([getattr(one, name) for one in run.passes])


_QUANTITIES: tuple[tuple[str, str, str, str], ...] = (
    ("rut_depth", "rut depth", r"u^r_0", "m"),
    ("shoulder_height", "height of the shoulders", r"-u^r_\mathrm{min}", "m"),
    ("resistance", "energy taken up per length", "F", "N"),
    ("track_plastic_strain", "plastic strain under the track", r"\varepsilon^p_\mathrm{eq}", "%"),
    ("track_plastic_increment", "its growth per pass", r"\Delta\varepsilon^p_\mathrm{eq}", "%"),
    ("dissipation", "dissipation per pass", "W^p", "J"),
)
"""Attribute of RollingPass, title, symbol, unit."""

_FALLING = ("track_plastic_increment", "dissipation")  # towards shakedown: over decades


@style.figure
@of_runs
def pass_by_pass(runs: Sequence[Run], *, ax: style.Target | None = None) -> Figure | None:
    """Rut, shoulders, resistance, plastic strain under the middle of the track, its growth, dissipation by pass.

    Growth and dissipation have a logarithmic axis if they fall by more than a factor of a hundred.

    Returns:
        None if no run has two passes: the summary tells the numbers of one.
    """
    shown = entries(runs, "rolling")
    if all(len(entry.run.passes) < 2 for entry in shown):
        return None
    fig = style.new_figure(11.0, 5.6)
    axes = fig.subplots(2, 3, sharex=True)
    for ax, quantity, letter in zip(axes.flat, _QUANTITIES, "abcdef", strict=True):
        _draw_by_pass(ax, shown, *quantity)
        ax.set_title(f"({letter})  {quantity[1]}")
    for ax in axes[1]:
        ax.set_xlabel("pass")
        ax.xaxis.set_major_locator(MaxNLocator(integer=True, min_n_ticks=1, nbins=6))
    most = max(len(entry.run.passes) for entry in shown)
    axes[0, 0].set_xlim(0.5, most + 0.5)
    legend_beside(axes[0, 2], [{**entry.look, "marker": "o"} for entry in shown])
    return fig


def _draw_by_pass(ax: Axes, shown: Sequence[Entry], name: str, _: str, symbol: str, unit: str) -> None:
    values = [_of_passes(entry.run, name) for entry in shown]
    scale = PERCENT if unit == "%" else si(largest(values), unit)
    for entry, value in zip(shown, values, strict=True):
        ax.plot(np.arange(1, len(value) + 1), value / scale.size, **entry.look, marker="o", clip_on=False)
    ax.set_ylabel(scale.label("", symbol))
    smallest = min(float(value.min()) for value in values)
    if name in _FALLING and 0.0 < 100.0 * smallest < largest(values):
        ax.set_yscale("log")
    elif smallest >= 0.0:
        ax.set_ylim(0.0, 1.08 * largest(values) / scale.size or 1.0)
    else:
        zero_line(ax)


def _across(body: BodyFields) -> FloatArray:
    """Height of the residual surface over y at x = 0 [m]."""
    return at_centre(body.x, -body.residual_displacement.T)


@style.figure
@of_runs
def track_profile(runs: Sequence[Run], *, ax: style.Target | None = None) -> Figure | None:
    """Residual surface of the lower body across the track at x = 0, after the last pass.

    Returns None if no lower body has yielded, and for plane strain, where nothing varies across the track.
    """
    bodies = [(entry, entry.run.snapshot("final").lower) for entry in entries(runs, "rolling")]
    deformed = [(entry, body) for entry, body in bodies if body.y.size > 1 and body.is_dented]
    if not deformed:
        return None
    height = si(largest(_across(body) for _, body in deformed), "m")
    width = si(largest(body.y for _, body in deformed), "m")
    fig = style.new_figure(5.6, 3.3)
    ax = fig.subplots()
    zero_line(ax)
    shown = [{**entry.look, "label": _after_passes(entry)} for entry, _ in deformed]
    for look, (_, body) in zip(shown, deformed, strict=True):
        ax.plot(body.y / width.size, _across(body) / height.size, **look, marker="o", markersize=2.5)
    ax.set_xlabel(width.label("across the track", "y"))
    ax.set_ylabel(height.label("height", "-u^r"))
    ax.margins(x=0.0)
    legend_beside(ax, shown)
    return fig


def _after_passes(entry: Entry) -> str:
    count = len(entry.run.passes)
    return f"{entry.label}, {count} {'pass' if count == 1 else 'passes'}"


def rolled(one: History) -> History:
    """The part of a pass between pressing on and lifting off."""
    moving = np.flatnonzero(np.diff(one["x"]))
    return one.part(slice(int(moving[0]), int(moving[-1]) + 2)) if moving.size else one


def _along(shown: Sequence[Entry]) -> list[tuple[History, Look]]:
    """Passes and their looks: all of a single run; first (solid) and last (dotted) of several runs."""
    if len(shown) == 1:
        parts = shown[0].run.history.passes()
        colours = style.family_colours(len(parts))
        return [
            (rolled(part), {"label": str(number), "color": colour})
            for number, (part, colour) in enumerate(zip(parts, colours, strict=True), start=1)
        ]
    return [line for entry in shown for line in _first_and_last(entry)]


def _first_and_last(entry: Entry) -> list[tuple[History, Look]]:
    parts = entry.run.history.passes()
    lines: list[tuple[History, Look]] = []
    for number, dash in {1: "-", len(parts): ":" if len(parts) > 1 else "-"}.items():
        look = {"label": f"{entry.label}, pass {number}", "color": entry.look["color"], "linestyle": dash}
        lines.append((rolled(parts[number - 1]), look))
    return lines


@style.figure
@of_runs
def along_track(runs: Sequence[Run], *, ax: style.Target | None = None) -> Figure:
    """Resistance F_X and approach along the track by pass; the load is drawn in place of an imposed approach.

    With sliding under a load the friction F_X/F_n is drawn in place of the resistance, with the area of contact. A
    single run shows all passes; of several runs the first and the last are drawn.
    """
    shown = entries(runs, "rolling")
    lines = _along(shown)
    imposed = all(entry.run.case("rolling", "approach") is not None for entry in shown)
    quantities = [
        *(_OF_SLIDING if _all_slide(shown) and not imposed else [("F_X", "resistance", "F_X", "N")]),
        ("F_n", "load", "F_n", "N") if imposed else ("approach", "approach", r"\alpha", "m"),
    ]
    length = si(largest(one["x"] for one, _ in lines), "m")
    fig = style.new_figure(6.6, 2.7 * len(quantities))
    axes = fig.subplots(len(quantities), 1, sharex=True)
    for ax, (column, name, symbol, unit) in zip(axes, quantities, strict=True):
        scale = _scale_of([one[column] for one, _ in lines], unit)
        for one, look in lines:
            ax.plot(one["x"] / length.size, one[column] / scale.size, **look)
        ax.set_ylabel(scale.label(name, symbol) if unit != "1" else f"{name}  ${symbol}$")
        if column in ("F_X", "friction"):
            zero_line(ax)
    axes[-1].set_xlabel(length.label("place of the contact", "x"))
    axes[-1].margins(x=0.02)
    handles = [look for _, look in lines]
    if len(shown) == 1:
        legend_beside(axes[0], evenly_chosen(handles, 8), title="pass")
    else:
        legend_beside(axes[0], handles)
    return fig


_OF_SLIDING = (("friction", "friction", "F_X/F_n", "1"), ("contact_area", "area of contact", "A", "m²"))
"""Column, name, symbol, unit of what is drawn if a body slides."""


def _all_slide(shown: Sequence[Entry]) -> bool:
    """Whether the surfaces have different speeds in each run; results of older versions have no friction."""
    return all(entry.run.case("rolling", "slide_to_roll") and "friction" in entry.run.history for entry in shown)


def _scale_of(values: Sequence[FloatArray], unit: str) -> Scale:
    if unit == "1":
        return Scale(1.0, "", "")
    if unit == "m²":  # a prefix of it would count twice
        return Scale(1e-12, "", "µm²") if largest(values) < 1e-7 else Scale(1e-6, "", "mm²")
    return si(largest(values), unit)


_OF_CREEP = (
    ("F_x", "longitudinal force", "F_x/(fP)"),
    ("F_y", "lateral force", "F_y/(fP)"),
    ("M_z", "moment", "M_z/(fPa)$\ncontact area $\\pi a^2"),
    ("stick_share", "share that sticks", ""),
)
"""Column, name, symbol. Forces are over friction times load, the moment over that times the radius of a circle of the
contact's area A."""


def creeps(run: Run) -> bool:
    """Whether the surfaces stick and slip."""
    return run.case("rolling", "creepage") is not None or run.case("rolling", "spin") is not None


def _of_creep(part: History, friction: float, column: str) -> FloatArray:
    values = np.asarray(part[column], dtype=float)
    if column == "stick_share":
        return values
    bound = friction * np.maximum(part["F_n"], np.finfo(float).tiny)
    if column == "M_z":
        bound = bound * np.sqrt(np.maximum(part["contact_area"], np.finfo(float).tiny) / np.pi)
    return np.asarray(values / bound)


def _distance_rolled(part: History) -> FloatArray:
    return np.asarray(part["x"] - part["x"][0])


@style.figure
@of_runs
def creep_forces(runs: Sequence[Run], *, ax: style.Target | None = None) -> Figure | None:
    """Forces, moment and sticking share over the distance rolled in each pass, from rest to steady rolling.

    A force that is never more than a thousandth of friction times load has no panel. Returns None without creepage.
    """
    shown = [entry for entry in entries(runs, "rolling") if creeps(entry.run)]
    if not shown:
        return None
    lines = [
        (part, look, float(entry.run.case("interface", "friction") or 0.0))
        for entry in shown
        for part, look in (_along(shown) if len(shown) == 1 else _first_and_last(entry))
    ]
    panels = [
        one
        for one in _OF_CREEP
        if one[0] == "stick_share" or largest(_of_creep(part, f, one[0]) for part, _, f in lines) > 1e-3
    ]
    length = si(largest(_distance_rolled(part) for part, _, _ in lines), "m")
    fig = style.new_figure(6.6, 1.2 + 1.9 * len(panels))
    axes = np.atleast_1d(fig.subplots(len(panels), 1, sharex=True))
    for ax, (column, name, symbol) in zip(axes, panels, strict=True):
        for part, look, friction in lines:
            ax.plot(_distance_rolled(part) / length.size, _of_creep(part, friction, column), **look)
        ax.set_ylabel(f"{name}  ${symbol}$" if symbol else name)
        if column == "stick_share":
            ax.set_ylim(0.0, 1.0)
        else:
            zero_line(ax)
    axes[-1].set_xlabel(length.label("distance rolled", "s"))
    axes[-1].margins(x=0.02)
    handles = [look for _, look, _ in lines]
    legend_beside(axes[0], evenly_chosen(handles, 8), title="pass" if len(shown) == 1 else None)
    return fig


def _state(run: Run, which: Which) -> Snapshot | None:
    """A stored state with stick and slip; None if there is none."""
    return state_with_slip(run, which) if creeps(run) else None


def _only_state(runs: Sequence[Run], which: Which) -> Snapshot | None:
    """The state of a single run; None of several runs."""
    return _state(runs[0], which) if len(runs) == 1 else None


@of_runs
def creep_maps(
    runs: Sequence[Run], which: Which = "aligned", *, cells: bool = False, ax: style.Target | None = None
) -> Figure | None:
    """Maps of the contact of a single run: pressure with shear as arrows, sticking area, shear and slip.

    Returns None for several runs, for plane strain, and without creepage.

    Args:
        runs: one.
        which: number of a stored step; "aligned", the middle of the last pass; or "final".
        cells: show each cell as a rectangle of one colour.
        ax: axes of the caller, one per panel, or a figure, to draw into; None: a new figure.
    """
    require_scenario(runs, "rolling")
    snapshot = _only_state(runs, which)
    if snapshot is None or snapshot.contact.y.size == 1:
        return None
    return stick_slip_maps(runs[0], snapshot, cells=cells, ax=ax)


@of_runs
def creep_heat(
    runs: Sequence[Run], which: Which = "aligned", *, cells: bool = False, ax: style.Target | None = None
) -> Figure | None:
    """Energy that friction has dissipated per area since each place came under the contact, with the sticking area.

    Returns None for several runs, and without creepage.

    Args:
        runs: one.
        which: number of a stored step; "aligned", the middle of the last pass; or "final".
        cells: show each cell as a rectangle of one colour.
        ax: axes of the caller, one per panel, or a figure, to draw into; None: a new figure.
    """
    require_scenario(runs, "rolling")
    snapshot = _only_state(runs, which)
    if snapshot is None or not has_friction_heat(snapshot):
        return None
    return friction_heat_map(runs[0], snapshot, cells=cells, ax=ax)


@of_runs
def creep_profiles(runs: Sequence[Run], which: Which = "aligned", *, ax: style.Target | None = None) -> Figure | None:
    """Shear between the bounds of friction, and slip, along the motion through the middle of the contact.

    Returns None without creepage.

    Args:
        runs: one or several.
        which: number of a stored step; "aligned", the middle of the last pass; or "final".
        ax: axes of the caller, one per panel, or a figure, to draw into; None: a new figure.
    """
    states = [(entry.run, _state(entry.run, which), entry.look) for entry in entries(runs, "rolling")]
    loaded = [(run, snapshot, look) for run, snapshot, look in states if snapshot is not None]
    return stick_slip_profiles(loaded, ax=ax) if loaded else None
