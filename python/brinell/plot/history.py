# SPDX-License-Identifier: BSD-3-Clause
"""The course of one run: forces, energies, contact, permanent deformation and cost, step by step."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator
from numpy.typing import NDArray

from brinell.plot import style
from brinell.plot.scales import PERCENT, Scale, Scales
from brinell.results import History, Run
from brinell.scenarios import SCENARIOS

__all__ = [
    "Course",
    "Panel",
    "approach",
    "course_of",
    "force_across_and_slopes",
    "force_along_surface",
    "normal_force",
    "resistance_to_rolling",
    "resistance_to_sliding",
    "run_history",
    "shares_of_contact",
    "tangential_force_and_slopes",
]

_LOWER: Mapping[str, Any] = {"color": style.LOWER}
_UPPER: Mapping[str, Any] = {"color": style.UPPER, "linestyle": (0, (4, 2))}  # often equal to the lower: both must show
_FRICTION: Mapping[str, Any] = {"color": style.CATEGORIES[3]}
_ASIDE: Mapping[str, Any] = {"color": style.REFERENCE, "linestyle": ":", "linewidth": 1.4}


@dataclass(frozen=True, eq=False)
class Course:
    """The passes of a run over a common abscissa."""

    passes: list[History]
    x: list[NDArray[np.float64]]
    """By pass, over its scale."""
    label: str
    scales: Scales

    @property
    def several(self) -> bool:
        """Whether there is more than one pass."""
        return len(self.passes) > 1

    def largest(self, *names: str) -> float:
        """Largest magnitude of some columns [SI]."""
        return max(
            (float(np.max(np.abs(one[name]))) for one in self.passes for name in names if name in one), default=0.0
        )

    def draw(self, ax: Axes, name: str, scale: Scale, label: str, look: Mapping[str, Any]) -> None:
        """Draws one quantity over all passes, with a gap between two passes; nothing if it is zero throughout."""
        if self.largest(name) == 0.0:
            return
        for index, (x, one) in enumerate(zip(self.x, self.passes, strict=True)):
            ax.plot(x, one[name] / scale.size, label=label if index == 0 else "_", **look)


def course_of(run: Run) -> Course:
    """The course over the steps; for tugging over the sliding coordinate, or the sliding distance in several passes."""
    passes = [run.history] if SCENARIOS[run.scenario].continuous else run.history.passes()
    scales = Scales(run)
    abscissa = SCENARIOS[run.scenario].abscissa
    if abscissa is None:
        return Course(passes, [one["step"] for one in passes], "step", scales)
    places = [one[abscissa] for one in passes]
    slid = _distance_slid(places) if len(passes) > 1 else places
    scale = scales.radius(max(float(np.max(np.abs(x))) for x in slid))
    name, symbol = ("distance slid", "s") if len(passes) > 1 else ("sliding coordinate", abscissa)
    return Course(passes, [x / scale.size for x in slid], scale.label(name, symbol), scales)


def _distance_slid(passes: list[NDArray[np.float64]]) -> list[NDArray[np.float64]]:
    """Sliding distance since the start of the first pass [m]."""
    result = []
    offset = 0.0
    for one in passes:
        slid = one - one[0]
        result.append(offset + slid)
        offset += slid[-1]
    return result


def _headroom(ax: Axes, factor: float) -> None:
    """Makes room for a legend above the curves."""
    ax.set_ylim(top=factor * ax.get_ylim()[1])


def _legend(ax: Axes, **place: Any) -> None:
    if ax.get_legend_handles_labels()[0]:
        ax.legend(**place)


def tangential_force_and_slopes(ax: Axes, course: Course) -> None:
    """F_X of two slopes that pass each other, with and without pile-up, and its part due to friction."""
    force = course.scales.force(course.largest("F_X"))
    course.draw(ax, "F_X", force, "with pile-up", _LOWER)
    course.draw(ax, "F_X_macro", force, "without", _ASIDE)
    course.draw(ax, "F_friction", force, "friction", _FRICTION)
    ax.axhline(0.0, color="0.8", linewidth=0.8, zorder=0.5)
    ax.set_title("tangential force")
    ax.set_ylabel(force.label("", "F_X"))
    _headroom(ax, 1.2)
    _legend(ax, loc="upper right", ncol=2)


def force_across_and_slopes(ax: Axes, course: Course) -> None:
    """F_Z of two slopes that pass each other, with and without pile-up, and its part due to friction."""
    force = course.scales.force(course.largest("F_Z"))
    course.draw(ax, "F_Z", force, "with pile-up", _LOWER)
    course.draw(ax, "F_Z_macro", force, "without", _ASIDE)
    ax.set_title("normal force")
    ax.set_ylabel(force.label("", "F_Z"))
    ax.set_ylim(bottom=0.0)


def resistance_to_rolling(ax: Axes, course: Course) -> None:
    """F_X and its part due to friction."""
    force = course.scales.force(course.largest("F_X", "F_friction"))
    course.draw(ax, "F_X", force, "resistance", _LOWER)
    if course.largest("F_friction") > 0.0:
        course.draw(ax, "F_friction", force, "friction", _FRICTION)
        _legend(ax)
    ax.axhline(0.0, color="0.8", linewidth=0.8, zorder=0.5)
    ax.set_title("resistance to rolling")
    ax.set_ylabel(force.label("", "F_X"))


def resistance_to_sliding(ax: Axes, course: Course) -> None:
    """F_X and its two parts."""
    force = course.scales.force(course.largest("F_X", "F_friction"))
    course.draw(ax, "F_X", force, "resistance", _LOWER)
    if course.largest("F_friction") > 0.0:
        course.draw(ax, "F_ploughing", force, "ploughing", _UPPER)
        course.draw(ax, "F_friction", force, "friction", _FRICTION)
        _legend(ax)
    ax.axhline(0.0, color="0.8", linewidth=0.8, zorder=0.5)
    ax.set_title("resistance to sliding")
    ax.set_ylabel(force.label("", "F_X"))


def force_along_surface(ax: Axes, course: Course) -> None:
    """The force that moves a body to and fro, and the resultant of the shear, which friction limits."""
    force = course.scales.force(course.largest("force", "F_friction"))
    course.draw(ax, "force", force, "along the motion", _LOWER)
    course.draw(ax, "F_friction", force, "resultant of the shear", _ASIDE)
    ax.axhline(0.0, color="0.8", linewidth=0.8, zorder=0.5)
    ax.set_title("force along the surface")
    ax.set_ylabel(force.label("", "Q"))
    _headroom(ax, 1.4)
    _legend(ax, loc="upper left", ncol=2)


def shares_of_contact(ax: Axes, course: Course) -> None:
    """Shares of the contact that stick, and that have reached the shear limit of the surface."""
    course.draw(ax, "stick_share", PERCENT, "sticks", _LOWER)
    course.draw(ax, "share_at_shear_limit", PERCENT, "at the shear limit", _UPPER)
    ax.set_title("share of the contact")
    ax.set_ylabel("share  [%]")
    ax.set_ylim(0.0, 125.0)
    ax.set_yticks(range(0, 101, 25))
    _legend(ax, loc="upper left", ncol=2)


def normal_force(ax: Axes, course: Course) -> None:
    """The normal force F_n."""
    force = course.scales.force(course.largest("F_n"))
    course.draw(ax, "F_n", force, "load", _LOWER)
    ax.set_title("normal force")
    ax.set_ylabel(force.label("", "F_n"))
    ax.set_ylim(bottom=0.0)


def approach(ax: Axes, course: Course) -> None:
    """The approach of the bodies."""
    depth = course.scales.displacement(course.largest("approach"))
    course.draw(ax, "approach", depth, "approach", _LOWER)
    ax.set_title("approach")
    ax.set_ylabel(depth.label("", r"\alpha"))
    if all(np.all(one["approach"] >= 0.0) for one in course.passes):
        ax.set_ylim(bottom=0.0)


def _energy(ax: Axes, course: Course) -> None:
    energy = course.scales.energy(course.largest("work", "dissipation_lower", "dissipation_upper"))
    course.draw(ax, "work", energy, "work", {"color": "black"})
    course.draw(ax, "dissipation_lower", energy, "dissipated, lower", _LOWER)
    course.draw(ax, "dissipation_upper", energy, "dissipated, upper", _UPPER)
    course.draw(ax, "dissipation_friction", energy, "heat of friction", _FRICTION)
    course.draw(ax, "energy_residual", energy, "locked in", {"color": style.LOCKED_IN})
    course.draw(ax, "energy_elastic", energy, "recoverable", _ASIDE)
    ax.set_title("energy since the start")
    ax.set_ylabel(energy.label("", "U"))
    ax.set_ylim(bottom=min(0.0, ax.get_ylim()[0]))
    _headroom(ax, 1.4)
    _legend(ax, loc="upper left", ncol=2)


def _pressure(ax: Axes, course: Course) -> None:
    pressure = course.scales.pressure(course.largest("max_pressure"))
    course.draw(ax, "max_pressure", pressure, "largest pressure", _LOWER)
    ax.set_title("largest pressure")
    ax.set_ylabel(pressure.label("", r"p_{\max}"))
    ax.set_ylim(bottom=0.0)


def _residual_depth(ax: Axes, course: Course) -> None:
    ax.set_title("residual depth")
    largest = course.largest("max_residual_lower", "max_residual_upper")
    if largest == 0.0:
        ax.text(0.5, 0.5, "nothing has yielded", transform=ax.transAxes, ha="center", va="center", color="0.4")
        ax.set_yticks([])
        return
    depth = course.scales.displacement(largest)
    course.draw(ax, "max_residual_lower", depth, "lower body", _LOWER)
    course.draw(ax, "max_residual_upper", depth, "upper body", _UPPER)
    ax.set_ylabel(depth.label("", r"u^r_{\max}"))
    ax.set_ylim(bottom=0.0)
    _headroom(ax, 1.2)
    _legend(ax, loc="upper left", ncol=2)


def _cost(ax: Axes, course: Course) -> None:
    for x, one in zip(course.x, course.passes, strict=True):
        ax.plot(x, one["evaluations"], linestyle="none", marker="o", color=style.LOWER)
    ax.set_title("cost")
    ax.set_ylabel("evaluations per step")
    ax.yaxis.set_major_locator(MaxNLocator(integer=True))
    ax.set_ylim(bottom=0.0)


Panel = Callable[[Axes, Course], None]
"""Draws one of the six."""
_COMMON: tuple[Panel, ...] = (_energy, _pressure, _residual_depth, _cost)


@style.figure
def run_history(run: Run, *, ax: style.Target | None = None) -> Figure:
    """Six panels over the steps; for tugging over the sliding coordinate, or the sliding distance in several passes.

    For an unfinished run the axes are in SI.
    """
    course, traits = course_of(run), SCENARIOS[run.scenario]
    panels = (*traits.panels(), *_COMMON)
    fig = style.new_figure(12.0, 6.6)
    axes = fig.subplots(2, 3, sharex=True)
    for ax, draw, letter in zip(axes.flat, panels, "abcdef", strict=True):
        draw(ax, course)
        ax.set_title(f"({letter})  {ax.get_title(loc='left')}")
        for x in course.x[1:]:
            ax.axvline(x[0], color="0.8", linewidth=0.8, zorder=0.5)
        if traits.abscissa is not None and not course.several:
            ax.axvline(0.0, color="0.8", linewidth=0.8, zorder=0.5)
    for ax in axes[1]:
        ax.xaxis.set_major_locator(MaxNLocator(nbins=5, steps=[1, 2, 5, 10]))
        ax.set_xlabel(course.label)
    return fig
