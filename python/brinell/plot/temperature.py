# SPDX-License-Identifier: BSD-3-Clause
"""Heat of friction: how warm the surfaces become, and how much heat each body takes."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator

from brinell.plot import style
from brinell.plot.history import Course, course_of
from brinell.plot.overlay import zero_line
from brinell.plot.scales import DEGREES, Scale, si
from brinell.results import History, Run
from brinell.scenarios import SCENARIOS

__all__ = ["surface_temperatures"]

_SIDES: tuple[tuple[str, Mapping[str, Any]], ...] = (
    ("lower", {"color": style.LOWER, "linestyle": "-"}),
    ("upper", {"color": style.UPPER, "linestyle": (0, (4, 2))}),  # often equal: both must show
)


def _is_heated(run: Run) -> bool:
    """Whether heat of friction was computed."""
    return any(np.any(run.history[name]) for name in ("heat_lower", "heat_upper") if name in run.history)


def _moving(one: History, column: str) -> History:
    """The part of a pass in which the contact moves, without pressing on and lifting off; all if it never does."""
    moving = np.flatnonzero(np.diff(one[column]))
    return one.part(slice(int(moving[0]), int(moving[-1]) + 2)) if moving.size else one


def _heated_course(run: Run) -> Course:
    """Over the distance, by which the surfaces heat: that of the history, or how far the bodies have slid or rolled."""
    course = course_of(run)
    if SCENARIOS[run.scenario].abscissa is not None:
        return course
    column, name = ("way", "way slid") if "way" in run.history else ("x", "distance rolled")
    passes = [_moving(one, column) for one in course.passes]
    ways = [np.abs(one[column] - one[column][0]) for one in passes]
    starts = np.cumsum([0.0, *(float(way[-1]) for way in ways[:-1])])
    scale = si(max(float(start + way[-1]) for start, way in zip(starts, ways, strict=True)), "m")
    x = [(start + way) / scale.size for start, way in zip(starts, ways, strict=True)]
    return Course(passes, x, scale.label(name, "s"), course.scales)


def _draw_course(ax: Axes, course: Course, column: str, scale: Scale, look: Mapping[str, Any]) -> None:
    """One column, the line broken between two passes."""
    for index, (x, one) in enumerate(zip(course.x, course.passes, strict=True)):
        ax.plot(x, one[column] / scale.size, **(look if index == 0 else {**look, "label": "_"}))


@style.figure
def surface_temperatures(run: Run) -> Figure | None:
    """Over the distance: the largest temperature of each surface, and the heat that has come into each body.

    The distance is the sliding coordinate of a tugging, the distance slid in several passes, otherwise the way slid or
    rolled; steps that press on and lift off have no place there. Beside it, the heat that has arisen in both of their
    plastic work.

    Returns:
        None if no heat was computed.
    """
    if not _is_heated(run):
        return None
    course = _heated_course(run)
    heat = si(course.largest("heat_lower", "heat_upper"), "J")
    fig = style.new_figure(9.6, 3.3)
    warm, taken = fig.subplots(1, 2, sharex=True)
    for side, look in _SIDES:
        _draw_course(warm, course, f"max_temperature_{side}", DEGREES, {**look, "label": side})
        _draw_course(taken, course, f"heat_{side}", heat, {**look, "label": side})
    if course.largest("heat_of_plastic_work") > 0.0:
        of_work = {"color": style.CATEGORIES[2], "linestyle": ":", "label": "of plastic work, both"}
        _draw_course(taken, course, "heat_of_plastic_work", heat, of_work)
        taken.legend()
    warm.set_title("(a)  hottest place of each surface")
    warm.set_ylabel(DEGREES.label("temperature", "T"))
    zero_line(taken)
    taken.set_title("(b)  heat in each body since the start")
    taken.set_ylabel(heat.label("", "Q"))
    at_alignment = [0.0] if SCENARIOS[run.scenario].abscissa is not None and not course.several else []
    for ax in (warm, taken):
        for place in (*at_alignment, *(float(x[0]) for x in course.x[1:])):
            ax.axvline(place, color="0.8", linewidth=0.8, zorder=0.5)
        ax.set_xlabel(course.label)
        ax.xaxis.set_major_locator(MaxNLocator(nbins=6, steps=[1, 2, 5, 10]))
        ax.margins(x=0.02)
    warm.legend()
    return fig
