# SPDX-License-Identifier: BSD-3-Clause
"""Histories of stress, plastic strain and temperature at the points that `output.points` of a case names."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator
from numpy.typing import NDArray

from brinell.plot import style
from brinell.plot.history import course_of
from brinell.plot.overlay import Look, largest, legend_beside, looks, zero_line
from brinell.plot.quantities import QUANTITIES
from brinell.plot.scales import DEGREES, PERCENT, Scale, Scales
from brinell.results import COMPONENTS, PointHistory, Run
from brinell.scenarios import SCENARIOS

__all__ = ["point_histories"]

FloatArray = NDArray[np.float64]

_MOST_TENSORS = 4
"""Points whose six components of stress are drawn."""


@dataclass(frozen=True, eq=False)
class _Abscissa:
    """What the histories are drawn over."""

    places: Mapping[int, float]
    """By step."""
    starts: frozenset[int]
    """First steps of the passes after the first one, before which a line is broken."""
    label: str

    def of(self, point: PointHistory) -> FloatArray:
        return np.array([self.places.get(int(step), np.nan) for step in point.step])

    def broken(self, point: PointHistory, values: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Places and values with a gap between two passes."""
        gaps = [i for i, step in enumerate(point.step) if int(step) in self.starts]
        return np.insert(self.of(point), gaps, np.nan), np.insert(values, gaps, np.nan)


def _abscissa(run: Run) -> _Abscissa:
    """The place of the contact in a single pass along x, otherwise that of the figure of the history."""
    course, motion = course_of(run), SCENARIOS[run.scenario].motion
    x, label = course.x, course.label
    if motion == "x" and not course.several:
        scale = course.scales.length(float(np.max(np.abs(run.history["x"]))))
        x = [one["x"] / scale.size for one in course.passes]
        label = scale.label("place of the contact", "x")
    steps = [one["step"].astype(int) for one in course.passes]
    places = {int(s): float(at) for one, over in zip(steps, x, strict=True) for s, at in zip(one, over, strict=True)}
    return _Abscissa(places, frozenset(int(one[0]) for one in steps[1:] if len(one)), label)


def _labels(points: Sequence[PointHistory]) -> list[str]:
    """Body and depth, and the place on the surface if one of them is not in the middle."""
    aside = any(point.x != 0.0 or point.y != 0.0 for point in points)

    def of(point: PointHistory) -> str:
        place = f"$x$ = {style.length(point.x)}, $y$ = {style.length(point.y)}, " if aside else ""
        return f"{point.body}, {place}$z$ = {style.length(point.depth)}"

    return [of(point) for point in points]


@style.figure
def point_histories(run: Run, *, ax: style.Target | None = None) -> Figure | None:
    """Stress, plastic strain and temperature at the points of `output.points` over the steps.

    Von Mises stress and, where there are any, equivalent plastic strain and temperature of all points, then the
    components of stress of each of the first four. A single rolling pass is drawn over the place of the contact,
    tugging over the sliding coordinate.

    Args:
        run: result to draw; it may be unfinished.

    Returns:
        None if the case names no points, or none within the bodies.
    """
    points = [point for point in run.points if np.any(np.isfinite(point["von_mises_stress"]))]
    if not points:
        return None
    over, scales = _abscissa(run), Scales(run)
    labels = _labels(points)
    names = ["von_mises_stress"]
    if _largest(points, ["equivalent_plastic_strain"]) > 0.0:
        names.append("equivalent_plastic_strain")
    if any(np.any(np.isfinite(point["temperature"])) for point in points):
        names.append("temperature")
    tensors = points[:_MOST_TENSORS]
    count = len(names) + len(tensors)
    fig = style.new_figure(11.0, 0.6 + 2.7 * -(-count // 2))
    axes = list(np.ravel(fig.subplots(-(-count // 2), 2, sharex=True, squeeze=False)))
    for ax, name in zip(axes, names, strict=False):
        _draw_all(ax, points, name, _scale(name, scales, points), looks(labels), over)
    stress = scales.stress(_largest(tensors, [f"stress_{c}" for c in COMPONENTS]))
    for ax, point, label in zip(axes[len(names) :], tensors, labels, strict=False):
        _draw_stress(ax, point, label, stress, over)
        if ax is not axes[len(names)]:
            ax.sharey(axes[len(names)])
    for ax, letter in zip(axes[:count], "abcdefgh", strict=False):
        ax.set_title(f"({letter})  {ax.get_title(loc='left')}")
        ax.xaxis.set_major_locator(MaxNLocator(nbins=6, steps=[1, 2, 5, 10]))
        ax.margins(x=0.02)
    for ax in axes[count:]:
        ax.set_axis_off()
    for ax in axes[max(0, count - 2) : count]:
        ax.set_xlabel(over.label)
        ax.tick_params(labelbottom=True)
    legend_beside(axes[1], looks(labels))
    axes[-1].legend(handles=axes[len(names)].lines[1:], loc="lower left", bbox_to_anchor=(1.02, 0.0), borderaxespad=0.0)
    return fig


def _scale(name: str, scales: Scales, points: Sequence[PointHistory]) -> Scale:
    if name == "temperature":
        return DEGREES
    return PERCENT if "strain" in name else scales.stress(_largest(points, [name]))


def _largest(points: Sequence[PointHistory], names: Sequence[str]) -> float:
    """Largest magnitude of some columns; they are NaN where the grid did not yet reach."""
    return largest(np.nan_to_num(point[name]) for point in points for name in names)


def _draw_all(
    ax: Axes, points: Sequence[PointHistory], name: str, scale: Scale, of_points: Sequence[Look], over: _Abscissa
) -> None:
    """Draws one quantity of all points."""
    quantity = QUANTITIES[name]
    for point, look in zip(points, of_points, strict=True):
        ax.plot(*over.broken(point, point[name] / scale.size), **look)
    title = quantity.title[0].lower() + quantity.title[1:] if name != "von_mises_stress" else quantity.title
    ax.set_title(title if len(points) > 1 else f"{title}, {of_points[0]['label']}")
    ax.set_ylabel(scale.label("", quantity.symbol))
    if name != "temperature":
        ax.set_ylim(bottom=0.0)


def _draw_stress(ax: Axes, point: PointHistory, label: str, scale: Scale, over: _Abscissa) -> None:
    """Draws the components of stress of one point."""
    zero_line(ax)
    for component, look in zip(COMPONENTS, looks([rf"$\sigma_{{{c}}}$" for c in COMPONENTS]), strict=True):
        ax.plot(*over.broken(point, point[f"stress_{component}"] / scale.size), **look)
    ax.set_title(f"stress, {label}")
    ax.set_ylabel(scale.label("", r"\sigma"))
