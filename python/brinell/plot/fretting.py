# SPDX-License-Identifier: BSD-3-Clause
"""Fretting: loops of force over displacement, stick and slip, cycle by cycle, and step by step.

SI with prefixes throughout. Displacement and force are those along the motion.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Literal

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.ticker import MaxNLocator
from numpy.typing import NDArray

from brinell.plot import style
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
from brinell.results import Run

__all__ = ["contact_heat", "contact_maps", "contact_profiles", "cycle_by_cycle", "force_loops", "fretting_course"]

FloatArray = NDArray[np.float64]
Which = int | Literal["aligned", "final"]

_MOST_IN_LEGEND = 8
_BOUND: Look = {"color": style.REFERENCE, "linestyle": "--", "linewidth": 0.9}


def _cycles(run: Run) -> dict[int, tuple[FloatArray, FloatArray]]:
    """Displacement [m] and force [N] of each cycle that has begun, starting in the middle of the motion."""
    number = run.history["cycle"]
    columns = run.history["displacement"], run.history["force"]
    found = {}
    for cycle in range(1, int(number.max(initial=0)) + 1):
        rows = np.flatnonzero(number == cycle)
        first = max(int(rows[0]) - 1, 0)  # where the cycle begins: the end of pressing, or of the cycle before
        displacement, force = (column[first : int(rows[-1]) + 1] for column in columns)
        found[cycle] = displacement, force
    return found


def _moving_load(run: Run) -> float:
    """Largest load while the bodies move [N]."""
    moving = run.history["cycle"] > 0
    return float(run.history["F_n"][moving].max(initial=0.0))


def _friction(run: Run) -> float:
    return float(run.case("interface", "friction") or 0.0)


@style.figure
@of_runs
def force_loops(runs: Sequence[Run], *, ax: style.Target | None = None) -> Figure | None:
    """Force over displacement: all cycles of a single run, the last cycle of each of several runs.

    The dashed line is the limit of friction. The limit of one run among several has the colour of its loop; a limit
    that several runs share is grey. Returns None if nothing has moved.
    """
    shown = entries(runs, "fretting")
    lines = _loop_lines(shown)
    if not lines:
        return None
    x = si(largest(displacement for displacement, _, _ in lines), "m")
    y = si(largest(force for _, force, _ in lines), "N")
    fig = style.new_figure(6.2, 4.3)
    ax = fig.subplots()
    zero_line(ax)
    ax.axvline(0.0, color="0.8", linewidth=0.8, zorder=0.5)
    for displacement, force, look in lines:
        ax.plot(displacement / x.size, force / y.size, **look)
    _draw_limits(ax, shown, y)
    ax.set_xlabel(x.label("displacement", r"\delta"))
    ax.set_ylabel(y.label("force along the surface", "Q"))
    handles = [look for _, _, look in lines]
    limit: Look = {**_BOUND, "label": r"friction $\times$ load"}
    if len(shown) == 1:
        legend = (
            [*evenly_chosen(handles, _MOST_IN_LEGEND), limit]
            if len(handles) > 1
            else [{**handles[0], "label": "cycle 1"}, limit]
        )
        legend_beside(ax, legend, title="cycle" if len(handles) > 1 else None)
    else:
        legend_beside(ax, [*handles, limit])
    return fig


def _loop_lines(shown: Sequence[Entry]) -> list[tuple[FloatArray, FloatArray, Look]]:
    if len(shown) == 1:
        cycles = _cycles(shown[0].run)
        colours = style.family_colours(len(cycles))
        return [
            (*line, {"label": str(cycle), "color": colour})
            for (cycle, line), colour in zip(cycles.items(), colours, strict=True)
        ]
    last = [(list(cycles.values())[-1], entry.look) for entry in shown if (cycles := _cycles(entry.run))]
    return [(*line, look) for line, look in last]


def _draw_limits(ax: Axes, shown: Sequence[Entry], force: Scale) -> None:
    """Draws friction times load, at the largest load while the bodies move."""
    limits = [_friction(entry.run) * _moving_load(entry.run) / force.size for entry in shown]
    for entry, limit in zip(shown, limits, strict=True):
        shared = len(shown) == 1 or sum(bool(np.isclose(limit, other, rtol=1e-3)) for other in limits) > 1
        colour = style.REFERENCE if shared else entry.look["color"]
        for sign in (1.0, -1.0):
            ax.axhline(sign * limit, **_BOUND | {"color": colour}, zorder=0.6)


@of_runs
def contact_maps(
    runs: Sequence[Run], which: Which = "aligned", *, cells: bool = False, ax: style.Target | None = None
) -> Figure | None:
    """Maps of the contact of a single run: pressure with shear as arrows, sticking area, shear and slip.

    Returns None for several runs, for plane strain, and if the state has no shear.

    Args:
        runs: one.
        which: number of a stored step; "aligned", the first turn; or "final".
        cells: show each cell as a rectangle of one colour.
        ax: axes of the caller, one per panel, or a figure, to draw into; None: a new figure.
    """
    require_scenario(runs, "fretting")
    snapshot = state_with_slip(runs[0], which) if len(runs) == 1 else None
    if snapshot is None or snapshot.contact.y.size == 1:
        return None
    return stick_slip_maps(runs[0], snapshot, cells=cells, ax=ax)


@of_runs
def contact_heat(
    runs: Sequence[Run], which: Which | None = None, *, cells: bool = False, ax: style.Target | None = None
) -> Figure | None:
    """Energy of a single run that friction has dissipated per area since the start, with the sticking area.

    Returns None for several runs, and if the state has no heat of friction.

    Args:
        runs: one.
        which: number of a stored step; "aligned", the first turn; "final"; or None, the last turn that is stored.
        cells: show each cell as a rectangle of one colour.
        ax: axes of the caller, one per panel, or a figure, to draw into; None: a new figure.
    """
    require_scenario(runs, "fretting")
    if len(runs) > 1:
        return None
    snapshot = state_with_slip(runs[0], _last_turn(runs[0]) if which is None else which)
    if snapshot is None or not has_friction_heat(snapshot):
        return None
    return friction_heat_map(runs[0], snapshot, cells=cells, ax=ax)


def _last_turn(run: Run) -> Which:
    """The last stored step at the end of a half cycle, where the sticking area is smallest."""
    imposed = np.abs(run.history["force" if run.case("fretting", "force") is not None else "displacement"])
    at = dict(zip(run.history["step"].astype(int).tolist(), imposed.tolist(), strict=True))
    turns = [step for step in run.steps if at.get(step, 0.0) >= (1.0 - 1e-6) * imposed.max(initial=0.0) > 0.0]
    return turns[-1] if turns else "aligned"


@of_runs
def contact_profiles(runs: Sequence[Run], which: Which = "aligned", *, ax: style.Target | None = None) -> Figure | None:
    """Shear between the bounds of friction, and slip, along the motion through the middle of the contact.

    Returns None if no state has a shear.

    Args:
        runs: one or several.
        which: number of a stored step; "aligned", the first turn; or "final".
        ax: axes of the caller, one per panel, or a figure, to draw into; None: a new figure.
    """
    states = [(entry.run, state_with_slip(entry.run, which), entry.look) for entry in entries(runs, "fretting")]
    loaded = [(run, snapshot, look) for run, snapshot, look in states if snapshot is not None]
    return stick_slip_profiles(loaded, ax=ax) if loaded else None


_OF_CYCLES: tuple[tuple[str, str, str, str], ...] = (
    ("dissipation_friction", "heat of friction", "W^f", "J"),
    ("dissipation_plastic", "plastic dissipation", "W^p", "J"),
    ("max_force", "largest force", r"Q_\mathrm{max}", "N"),
    ("slip_amplitude", "slip amplitude", "s_a", "m"),
    ("stick_share", "smallest share that sticks", r"A_\mathrm{st}/A", "%"),
    ("max_equivalent_plastic_strain", "largest plastic strain", r"\varepsilon^p_\mathrm{eq}", "%"),
)
"""Attribute of FrettingCycle, title, symbol, unit."""


@style.figure
@of_runs
def cycle_by_cycle(runs: Sequence[Run], *, ax: style.Target | None = None) -> Figure | None:
    """Heat of friction, plastic dissipation, largest force, slip amplitude, sticking share, plastic strain by cycle.

    Under an imposed force the largest displacement is drawn in place of the force. Returns None if no run has two
    cycles, because the numbers of a single cycle are in the summary.
    """
    shown = entries(runs, "fretting")
    if all(len(entry.run.cycles) < 2 for entry in shown):
        return None
    imposed = all(entry.run.case("fretting", "force") is not None for entry in shown)
    moved = ("max_displacement", "largest displacement", r"\delta_\mathrm{max}", "m")
    fig = style.new_figure(11.0, 5.6)
    axes = fig.subplots(2, 3, sharex=True)
    for ax, quantity, letter in zip(axes.flat, _OF_CYCLES, "abcdef", strict=True):
        drawn = moved if imposed and quantity[0] == "max_force" else quantity
        _draw_by_cycle(ax, shown, *drawn)
        ax.set_title(f"({letter})  {drawn[1]}")
    for ax in axes[1]:
        ax.set_xlabel("cycle")
        ax.xaxis.set_major_locator(MaxNLocator(integer=True, min_n_ticks=1, nbins=6))
    axes[0, 0].set_xlim(0.5, max(len(entry.run.cycles) for entry in shown) + 0.5)
    legend_beside(axes[0, 2], [{**entry.look, "marker": "o"} for entry in shown])
    return fig


def _draw_by_cycle(ax: Axes, shown: Sequence[Entry], name: str, _: str, symbol: str, unit: str) -> None:
    values = [np.array([getattr(cycle, name) for cycle in entry.run.cycles]) for entry in shown]
    scale = PERCENT if unit == "%" else si(largest(values), unit)
    for entry, value in zip(shown, values, strict=True):
        ax.plot(np.arange(1, len(value) + 1), value / scale.size, **entry.look, marker="o", clip_on=False)
    ax.set_ylabel(scale.label("", symbol))
    ax.set_ylim(0.0, 1.08 * largest(values) / scale.size or 1.0)


@style.figure
@of_runs
def fretting_course(runs: Sequence[Run], *, ax: style.Target | None = None) -> Figure:
    """Displacement, force between the limits of friction, energies, and approach or load over the steps.

    The load is drawn in place of an imposed approach.
    """
    shown = entries(runs, "fretting")
    imposed = all(entry.run.case("fretting", "approach") is not None for entry in shown)
    last = ("F_n", "load", "F_n", "N") if imposed else ("approach", "approach", r"\alpha", "m")
    fig = style.new_figure(9.6, 5.6)
    axes = fig.subplots(2, 2, sharex=True)
    _draw_course(axes[0, 0], shown, "displacement", "displacement", r"\delta", "m")
    force = _draw_course(axes[0, 1], shown, "force", "force along the surface", "Q", "N")
    for entry in shown:
        limit = _friction(entry.run) * entry.run.history["F_n"] / force.size
        colour = style.REFERENCE if len(shown) == 1 else entry.look["color"]
        for sign in (1.0, -1.0):
            axes[0, 1].plot(entry.run.history["step"], sign * limit, **{**_BOUND, "color": colour})
    if len(shown) == 1:
        axes[0, 1].set_title(f"{axes[0, 1].get_title(loc='left')}; dashed, friction $\\times$ load")
    _draw_energies(axes[1, 0], shown)
    _draw_course(axes[1, 1], shown, *last)
    for ax, letter in zip(axes.flat, "abcd", strict=True):
        ax.set_title(f"({letter})  {ax.get_title(loc='left')}")
        ax.margins(x=0.02)
        if len(shown) == 1:
            _mark_cycles(ax, shown[0].run)
    for ax in axes[1]:
        ax.set_xlabel("step")
        ax.xaxis.set_major_locator(MaxNLocator(integer=True, nbins=6))
    legend_beside(axes[0, 1], [entry.look for entry in shown])
    return fig


def _draw_course(ax: Axes, shown: Sequence[Entry], column: str, name: str, symbol: str, unit: str) -> Scale:
    scale = si(largest(entry.run.history[column] for entry in shown), unit)
    for entry in shown:
        ax.plot(entry.run.history["step"], entry.run.history[column] / scale.size, **entry.look)
    zero_line(ax)
    ax.set_title(name)
    ax.set_ylabel(scale.label("", symbol))
    return scale


def _draw_energies(ax: Axes, shown: Sequence[Entry]) -> None:
    """Draws heat of friction and plastic dissipation, of both bodies or, for several runs, their sum."""
    heat = [entry.run.history["dissipation_friction"] for entry in shown]
    plastic = [entry.run.history["dissipation_lower"] + entry.run.history["dissipation_upper"] for entry in shown]
    scale = si(largest([*heat, *plastic]), "J")
    if len(shown) > 1:
        for entry, one, other in zip(shown, heat, plastic, strict=True):
            ax.plot(entry.run.history["step"], (one + other) / scale.size, **entry.look)
        ax.set_title("heat of friction and plastic dissipation")
    else:
        steps = shown[0].run.history["step"]
        looks: list[Look] = [
            {"label": "heat of friction", "color": style.CATEGORIES[3]},
            {"label": "plastic, both bodies", "color": style.LOWER, "linestyle": (0, (4, 2))},
        ]
        for values, look in zip((heat[0], plastic[0]), looks, strict=True):
            ax.plot(steps, values / scale.size, **look)
        ax.legend(handles=[Line2D([], [], **look) for look in looks], loc="upper left", ncol=2)
        ax.set_title("dissipated since the start")
    ax.set_ylabel(scale.label("", "W"))
    ax.set_ylim(0.0, 1.25 * ax.get_ylim()[1])


def _mark_cycles(ax: Axes, run: Run) -> None:
    """Marks the beginnings of the cycles."""
    begins = np.flatnonzero(np.diff(run.history["cycle"]) > 0)
    if begins.size <= 20:
        for row in begins:
            ax.axvline(float(run.history["step"][row]), color="0.8", linewidth=0.8, zorder=0.5)
