# SPDX-License-Identifier: BSD-3-Clause
"""Sliding: friction and its two parts, contact and roughness, over the sliding distance and by stroke.

SI with prefixes throughout. Friction is the force along x over the load, positive where it resists the motion.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator
from numpy.typing import NDArray

from brinell.plot import style
from brinell.plot.overlay import Entry, Look, entries, largest, legend_beside, of_runs, zero_line
from brinell.plot.scales import PERCENT, Scale, area_scale, si
from brinell.results import Run

__all__ = ["along_way", "stroke_by_stroke"]

FloatArray = NDArray[np.float64]
_Series = Callable[[Run], FloatArray]

_PLAIN = Scale(1.0, "", "")
_PLOUGHING: Look = {"linestyle": "--", "linewidth": 1.0}
_LOWER: Look = {"color": style.LOWER, "marker": "o", "clip_on": False}
_UPPER: Look = {"color": style.UPPER, "marker": "s", "linestyle": (0, (4, 2)), "clip_on": False}


def _moving(run: Run) -> NDArray[np.bool_]:
    """The steps of sliding, without pressing and lifting off."""
    return np.diff(run.history["way"], prepend=0.0) > 0.0


def _over_load(run: Run, column: str) -> FloatArray:
    load = run.history["F_n"][_moving(run)]
    force = run.history[column][_moving(run)]
    return np.divide(force, load, out=np.zeros_like(force), where=load > 0.0)


def _has_period(shown: Sequence[Entry]) -> bool:
    return all(not np.all(np.isnan(entry.run.history["contact_fraction"])) for entry in shown)


@style.figure
@of_runs
def along_way(runs: Sequence[Run], *, ax: style.Target | None = None) -> Figure | None:
    """Friction (dashed: by ploughing), contact, gap and plastic work since the start over the sliding distance.

    In a period the contact is its share of the period and the gap is the mean gap; otherwise area and approach are
    drawn.

    Returns:
        None if nothing has slid.
    """
    shown = entries(runs, "sliding")
    if not any(_moving(entry.run).any() for entry in shown):
        return None
    way = si(largest(entry.run.history["way"] for entry in shown), "m")
    fig = style.new_figure(9.6, 5.6)
    axes = fig.subplots(2, 2, sharex=True)
    _draw_friction(axes[0, 0], shown, way)
    periodic = _has_period(shown)
    contact, gap = ("contact_fraction", "mean_gap") if periodic else ("contact_area", "approach")
    area = PERCENT if periodic else area_scale(largest(entry.run.history[contact] for entry in shown))
    _draw(axes[0, 1], shown, way, area, lambda run: run.history[contact])
    axes[0, 1].set_title("(b)  share of the period in contact" if periodic else "(b)  area of contact")
    axes[0, 1].set_ylabel(area.label("", "A/A_0" if periodic else "A"))
    axes[0, 1].set_ylim(bottom=0.0)
    length = si(largest(entry.run.history[gap][_moving(entry.run)] for entry in shown), "m")
    _draw(axes[1, 0], shown, way, length, lambda run: run.history[gap])
    axes[1, 0].set_title("(c)  mean gap" if periodic else "(c)  approach")
    axes[1, 0].set_ylabel(length.label("", r"\bar g" if periodic else r"\alpha"))
    energy = si(largest(_plastic(entry.run) for entry in shown), "J")
    _draw(axes[1, 1], shown, way, energy, _plastic)
    axes[1, 1].set_title("(d)  plastic work in both bodies since the start")
    axes[1, 1].set_ylabel(energy.label("", "W^p"))
    axes[1, 1].set_ylim(bottom=0.0)
    for ax in axes[1]:
        ax.set_xlabel(way.label("way slid", "s"))
    axes[0, 0].margins(x=0.02)
    legend_beside(axes[0, 1], [entry.look for entry in shown])
    return fig


def _plastic(run: Run) -> FloatArray:
    return run.history["dissipation_lower"] + run.history["dissipation_upper"]


def _draw(ax: Axes, shown: Sequence[Entry], way: Scale, scale: Scale, values: _Series) -> None:
    for entry in shown:
        moving = _moving(entry.run)
        ax.plot(entry.run.history["way"][moving] / way.size, values(entry.run)[moving] / scale.size, **entry.look)


def _draw_friction(ax: Axes, shown: Sequence[Entry], way: Scale) -> None:
    zero_line(ax)
    for entry in shown:
        x = entry.run.history["way"][_moving(entry.run)] / way.size
        ax.plot(x, _over_load(entry.run, "F_X"), **entry.look)
        if np.any(_over_load(entry.run, "F_friction")):
            ax.plot(x, _over_load(entry.run, "F_ploughing"), color=entry.look["color"], **_PLOUGHING)
    rubs = any(np.any(_over_load(entry.run, "F_friction")) for entry in shown)
    ax.set_title("(a)  friction; dashed, by ploughing" if rubs else "(a)  friction, by ploughing")
    ax.set_ylabel("$F_X/F_n$")


@style.figure
@of_runs
def stroke_by_stroke(runs: Sequence[Run], *, ax: style.Target | None = None) -> Figure | None:
    """Friction (dashed: by ploughing), contact, plastic work, and rms height of both surfaces by stroke.

    For several runs the heights are those of the lower surfaces.

    Returns:
        None if no run has two strokes: the summary tells the numbers of one.
    """
    shown = entries(runs, "sliding")
    if all(len(entry.run.strokes) < 2 for entry in shown):
        return None
    fig = style.new_figure(9.6, 5.6)
    axes = fig.subplots(2, 2, sharex=True)
    _draw_strokes(axes[0, 0], shown, _PLAIN, "friction")
    for entry in shown:
        if any(stroke.friction_interfacial for stroke in entry.run.strokes):
            _line(axes[0, 0], entry.run, "friction_ploughing", _PLAIN, {"color": entry.look["color"], **_PLOUGHING})
    zero_line(axes[0, 0])
    axes[0, 0].set_title("(a)  friction")
    axes[0, 0].set_ylabel("$F_X/F_n$")
    periodic = _has_period(shown)
    contact = "contact_fraction" if periodic else "contact_area"
    area = PERCENT if periodic else area_scale(largest(_of_strokes(entry.run, contact) for entry in shown))
    _draw_strokes(axes[0, 1], shown, area, contact)
    axes[0, 1].set_title("(b)  share of the period in contact" if periodic else "(b)  area of contact")
    axes[0, 1].set_ylabel(area.label("", "A/A_0" if periodic else "A"))
    axes[0, 1].set_ylim(bottom=0.0)
    energy = si(largest(_of_strokes(entry.run, "dissipation_plastic") for entry in shown), "J")
    _draw_strokes(axes[1, 0], shown, energy, "dissipation_plastic")
    axes[1, 0].set_title("(c)  plastic work of the stroke")
    axes[1, 0].set_ylabel(energy.label("", "W^p"))
    axes[1, 0].set_ylim(bottom=0.0)
    _draw_heights(axes[1, 1], shown)
    for ax in axes[1]:
        ax.set_xlabel("stroke")
        ax.xaxis.set_major_locator(MaxNLocator(integer=True, min_n_ticks=1, nbins=6))
    legend_beside(axes[0, 1], [{**entry.look, "marker": "o"} for entry in shown])
    return fig


def _of_strokes(run: Run, name: str) -> FloatArray:
    return np.array([getattr(one, name) for one in run.strokes])


def _line(ax: Axes, run: Run, name: str, scale: Scale, look: Look) -> None:
    values = _of_strokes(run, name)
    ax.plot(np.arange(1, len(values) + 1), values / scale.size, **look)


def _draw_strokes(ax: Axes, shown: Sequence[Entry], scale: Scale, name: str) -> None:
    for entry in shown:
        _line(ax, entry.run, name, scale, {**entry.look, "marker": "o", "clip_on": False})


def _draw_heights(ax: Axes, shown: Sequence[Entry]) -> None:
    names = ("rms_height_lower", "rms_height_upper") if len(shown) == 1 else ("rms_height_lower",)
    height = si(largest(_of_strokes(entry.run, name) for entry in shown for name in names), "m")
    if len(shown) > 1:
        _draw_strokes(ax, shown, height, "rms_height_lower")
        ax.set_title("(d)  rms height of the lower surface")
    else:
        _line(ax, shown[0].run, "rms_height_lower", height, {**_LOWER, "label": "lower"})
        _line(ax, shown[0].run, "rms_height_upper", height, {**_UPPER, "label": "upper"})
        ax.set_title("(d)  rms height of the surfaces")
        ax.legend()
    ax.set_ylabel(height.label("", "S_q"))
