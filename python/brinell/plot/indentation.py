# SPDX-License-Identifier: BSD-3-Clause
"""Indentations: load over approach, the imprint that is left, and the contact pressure, of one run or several.

SI with prefixes throughout. Approaches count from first touch of the undeformed bodies; heights of the
imprint are out of the lower body: pile-up positive.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from numpy.typing import NDArray

from brinell.plot import style
from brinell.plot.cells import at_centre
from brinell.plot.overlay import Entry, Look, entries, largest, legend_beside, looks, of_runs, zero_line
from brinell.plot.scales import Scale, common_scales, si, twin_axis
from brinell.results import BodyFields, History, Run

__all__ = ["contact_pressure", "imprint", "load_depth"]

FloatArray = NDArray[np.float64]

_CELLS: Look = {"marker": "o", "markersize": 2.5}  # shows how fine the grid is


@dataclass(frozen=True, eq=False)
class _Line:
    """Load over approach in SI."""

    depth: FloatArray
    load: FloatArray
    look: Look


def _touches_at_zero(run: Run) -> bool:
    """Whether the bodies first touch at depth 0; textures shift this depth."""
    textures = [run.case(body, "texture") for body in ("lower", "upper")]
    return all(isinstance(texture, dict) and texture["type"] == "smooth" for texture in textures)


def _curve(run: Run, rows: History, *, is_first: bool) -> tuple[FloatArray, FloatArray]:
    """Depth [m] and load [N] at one place, cycle after cycle; from first touch if it is known."""
    depth, load = rows["approach"], rows["F_n"]
    if is_first and _touches_at_zero(run):
        return np.concatenate([[0.0], depth]), np.concatenate([[0.0], load])
    return depth, load


def _load_lines(entry: Entry, *, alone: bool) -> list[_Line]:
    """One line per place; a single run has a label for each place, several runs have a look each."""
    places = entry.run.history.split("place")
    each = [{**entry.look, "linestyle": "-"}] * len(places)  # cycles on each other would fill the gaps of a dash
    if alone and len(places) > 1:
        each = looks([f"$x$ = {style.length(rows['x'][0])}" for rows in places])
    return [
        _Line(*_curve(entry.run, rows, is_first=index == 0), look)
        for index, (rows, look) in enumerate(zip(places, each, strict=True))
    ]


def _elastic_depth(run: Run, load: FloatArray) -> FloatArray | None:
    """Approach of the elastic contact under these loads [m].

    None unless both bodies are smooth, and round, flat, or cylinders in plane strain.
    """
    shapes = {run.case(body, "shape", "type") for body in ("lower", "upper")}
    if not (
        shapes <= {"sphere", "ellipsoid", "cylinder", "flat"} and _touches_at_zero(run) and run.has_critical_values
    ):
        return None
    critical, reference = run.critical, run.line_reference
    if reference is None:
        return critical.interference * (load / critical.load) ** (2.0 / 3.0)
    a = critical.contact_radius * np.sqrt(load / critical.load)
    approach = np.zeros_like(load)
    pressed = a > 0.0
    a = a[pressed]
    approach[pressed] = a**2 / (4.0 * run.equivalent_radius) * (1.0 + 2.0 * np.log(2.0 * reference / a))
    return approach


def _hertz_line(runs: Sequence[Run], load: float) -> _Line | None:
    """The elastic curve up to a load [N], if it is the same for all runs."""
    P = load * np.linspace(0.0, 1.0, 101)
    depths = [_elastic_depth(run, P) for run in runs]
    first = depths[0]
    if first is None or any(depth is None or not np.allclose(depth, first, rtol=1e-6, atol=0.0) for depth in depths):
        return None
    look = {"label": "elastic (Hertz)", "color": style.REFERENCE, "linestyle": "--", "linewidth": 0.9}
    return _Line(first, P, look)


@style.figure
@of_runs
def load_depth(runs: Sequence[Run], *, ax: style.Target | None = None) -> Figure:
    """Load over approach in loading and unloading of all cycles; elastic spheres or cylinders are dashed.

    If first yield exists and is the same for all runs, second axes show both normalised by it.
    """
    shown = entries(runs, "indentation")
    lines = [line for entry in shown for line in _load_lines(entry, alone=len(shown) == 1)]
    elastic = _hertz_line(runs, largest(line.load for line in lines))
    lines += [elastic] if elastic else []
    depth, load = si(largest(line.depth for line in lines), "m"), si(largest(line.load for line in lines), "N")
    fig = style.new_figure(5.8, 4.3)
    ax = fig.subplots()
    for line in lines:
        ax.plot(line.depth / depth.size, line.load / load.size, **line.look)
    ax.set_ylim(bottom=0.0)
    if all(np.all(line.depth >= 0.0) for line in lines):
        ax.set_xlim(left=0.0)
    ax.set_xlabel(depth.label("approach", r"\alpha"))
    ax.set_ylabel(load.label("load", "F_n"))
    common = common_scales(runs)
    if common:
        twin_axis(ax, "x", depth, common.displacement(0.0), r"\alpha")
        twin_axis(ax, "y", load, common.force(0.0), "F_n")
    handles = list({line.look["label"]: line.look for line in lines}.values())
    if len(handles) > 1:  # above the curves, which begin at the lower left
        ax.legend(handles=[Line2D([], [], **look) for look in handles], loc="upper left")
    return fig


@dataclass(frozen=True, eq=False)
class _Imprint:
    """Heights of the lower body in two planes [m]."""

    entry: Entry
    body: BodyFields
    place: float
    """Where the plane along y cuts: the first place [m]."""

    @property
    def along_x(self) -> FloatArray:
        return at_centre(self.body.y, -self.body.residual_displacement)

    @property
    def along_y(self) -> FloatArray:
        """Profile on x = 0, linear between two columns of cells."""
        rows = -self.body.residual_displacement
        return np.array([np.interp(self.place, self.body.x, row) for row in rows])


def _imprints(shown: Sequence[Entry]) -> list[_Imprint]:
    """Imprints of the runs whose lower body has yielded."""
    result = []
    for entry in shown:
        body = entry.run.snapshot("final").lower
        if body.is_dented:
            result.append(_Imprint(entry, body, float(entry.run.history["x"][0])))
    return result


def _reach(x: FloatArray, height: FloatArray) -> tuple[float, float]:
    """Range where a profile exceeds a fiftieth of its largest height or depth, with a margin, within the grid [m]."""
    moved = x[np.abs(height) > 0.02 * np.abs(height).max(initial=0.0)]
    if moved.size == 0:
        return float(x[0]), float(x[-1])
    margin = 0.1 * float(moved[-1] - moved[0])
    return max(float(x[0]), float(moved[0]) - margin), min(float(x[-1]), float(moved[-1]) + margin)


@style.figure
@of_runs
def imprint(runs: Sequence[Run], *, ax: style.Target | None = None) -> Figure | None:
    """Residual surface of the lower body along x and y through the first place; below, its pile-up enlarged.

    Returns None if no lower body has yielded.
    """
    imprints = _imprints(entries(runs, "indentation"))
    if not imprints:
        return None
    highest = max(float((-i.body.residual_displacement).max()) for i in imprints)
    deepest = max(float(i.body.residual_displacement.max()) for i in imprints)
    height, length = si(max(highest, deepest), "m"), si(largest(i.body.x for i in imprints), "m")
    rows = 2 if highest > 1e-3 * deepest else 1
    planes = 1 if all(i.body.y.size == 1 for i in imprints) else 2  # plane strain has no profile along y
    fig = style.new_figure(4.3 * planes, 2.6 + 2.0 * (rows - 1))
    axes = fig.subplots(rows, planes, sharex="col", sharey="row", squeeze=False, height_ratios=[1.5, 1.0][:rows])
    for ax in axes.flat:
        zero_line(ax)
    for one in imprints:
        for ax in axes[:, 0]:
            ax.plot(one.body.x / length.size, one.along_x / height.size, **one.entry.look)
        for ax in axes[:, 1:].flat:
            ax.plot(one.body.y / length.size, one.along_y / height.size, **one.entry.look)
    _limit(axes[0, 0], [_reach(i.body.x, i.along_x) for i in imprints], length)
    if planes == 2:
        _limit(axes[0, 1], [_reach(i.body.y, i.along_y) for i in imprints], length)
        axes[0, 1].set_title(f"(b)  along $y$, through {_cut(imprints)}")
        axes[-1, 1].set_xlabel(length.label("", "y"))
    if rows == 2:
        axes[1, 0].set_ylim(-0.4 * highest / height.size, 1.15 * highest / height.size)
        axes[1, 0].set_ylabel(height.label("pile-up", "-u^r"))
    axes[0, 0].set_ylabel(height.label("height", "-u^r"))
    axes[0, 0].set_title("(a)  along $x$, through $y$ = 0")
    axes[-1, 0].set_xlabel(length.label("", "x"))
    legend_beside(axes[0, -1], [one.entry.look for one in imprints])
    return fig


def _limit(ax: Axes, reaches: Sequence[tuple[float, float]], scale: Scale) -> None:
    ax.set_xlim(min(low for low, _ in reaches) / scale.size, max(high for _, high in reaches) / scale.size)


def _cut(imprints: Sequence[_Imprint]) -> str:
    places = {one.place for one in imprints}
    if len(places) > 1:
        return "the first place"
    return f"$x$ = {style.length(places.pop())}"


@style.figure
@of_runs
def contact_pressure(runs: Sequence[Run], *, ax: style.Target | None = None) -> Figure | None:
    """Contact pressure along x' and y' through the middle of the contact, at the largest load that is stored.

    Returns None if no run has stored a loaded state.
    """
    states = [(e, e.run.snapshot("aligned")) for e in entries(runs, "indentation") if e.run.steps]
    loaded = [(entry, snapshot) for entry, snapshot in states if snapshot.in_contact]
    if not loaded:
        return None
    contacts = [snapshot.contact for _, snapshot in loaded]
    pressure = si(largest(c.pressure for c in contacts), "Pa")
    reach = 1.25 * max(largest(c.x[np.any(c.pressure > 0.0, axis=0)] for c in contacts), contacts[0].x[1])
    length = si(reach, "m")
    fig = style.new_figure(8.6, 3.3)
    left, right = fig.subplots(1, 2, sharey=True)
    shown = [
        {**entry.look, "label": f"{entry.label},  $F_n$ = {style.quantity(snapshot.row['F_n'], 'N')}"}
        for entry, snapshot in loaded
    ]
    for look, c in zip(shown, contacts, strict=True):
        left.plot(c.x / length.size, at_centre(c.y, c.pressure) / pressure.size, **look, **_CELLS)
        right.plot(c.y / length.size, at_centre(c.x, c.pressure.T) / pressure.size, **look, **_CELLS)
    for ax, letter, along, across in ((left, "a", "x", "y"), (right, "b", "y", "x")):
        ax.set_title(f"({letter})  along ${along}'$, through ${across}'$ = 0")
        ax.set_xlabel(length.label("", f"{along}'"))
        ax.set_xlim(-reach / length.size, reach / length.size)
    left.set_ylim(bottom=0.0)
    left.set_ylabel(pressure.label("contact pressure", "p"))
    legend_beside(right, shown)
    return fig
