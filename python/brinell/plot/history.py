# SPDX-License-Identifier: BSD-3-Clause
"""The course of one run: forces, energies, contact, permanent deformation and cost, step by step."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator
from numpy.typing import NDArray

from brinell.plot import style
from brinell.plot.scales import Scale, Scales
from brinell.results import History, Run

__all__ = ["run_history"]


def _course(passes: list[History]) -> list[NDArray[np.float64]]:
    """Abscissa of each pass [m]: X; if there are several passes, the distance slid since the start of the first."""
    if len(passes) == 1:
        return [passes[0]["X"]]
    course = []
    offset = 0.0
    for one in passes:
        slid = one["X"] - one["X"][0]
        course.append(offset + slid)
        offset += slid[-1]
    return course


@style.figure
def run_history(run: Run) -> Figure:
    """Six panels over the sliding coordinate, or over the distance slid if there are several passes.

    Works for a run that has not finished: the axes are then in SI.
    """
    passes = run.history.passes()
    scales = Scales(run)
    course = _course(passes)
    several = len(passes) > 1
    x_scale = scales.radius(max(float(np.max(np.abs(x))) for x in course))
    x_label = x_scale.label("distance slid" if several else "sliding coordinate", "s" if several else "X")

    fig = style.new_figure(12.0, 6.6)
    panels = fig.subplots(2, 3, sharex=True)

    def curve(ax: Axes, name: str, scale: Scale, label: str, **look: object) -> None:
        """One quantity over all passes, the line broken between two."""
        for index, (x, one) in enumerate(zip(course, passes, strict=True)):
            ax.plot(x / x_scale.size, one[name] / scale.size, label=label if index == 0 else "_", **look)  # type: ignore[arg-type]

    def largest(*names: str) -> float:
        return max(float(np.max(np.abs(run.history[name]))) for name in names)

    lower = {"color": style.LOWER}
    upper = {"color": style.UPPER, "linestyle": (0, (4, 2))}  # often equal to the lower body: both must show
    reference = {"color": style.REFERENCE, "linestyle": ":", "linewidth": 1.4}

    force = scales.force(largest("F_X"))
    ax = panels[0, 0]
    curve(ax, "F_X", force, "with pile-up", color=style.LOWER)
    curve(ax, "F_X_macro", force, "without", **reference)
    ax.axhline(0.0, color="0.8", linewidth=0.8, zorder=0.5)
    ax.set_title("(a)  tangential force")
    ax.set_ylabel(force.label("", "F_X"))
    ax.set_ylim(top=1.2 * ax.get_ylim()[1])  # room for the legend
    ax.legend(loc="upper right", ncol=2)

    force = scales.force(largest("F_Z"))
    ax = panels[0, 1]
    curve(ax, "F_Z", force, "with pile-up", color=style.LOWER)
    curve(ax, "F_Z_macro", force, "without", **reference)
    ax.set_title("(b)  normal force")
    ax.set_ylabel(force.label("", "F_Z"))

    energy = scales.energy(largest("work", "dissipation_lower", "dissipation_upper"))
    ax = panels[0, 2]
    curve(ax, "work", energy, "work of $F_X$", color="black")
    curve(ax, "dissipation_lower", energy, "dissipated, lower", **lower)
    curve(ax, "dissipation_upper", energy, "dissipated, upper", **upper)
    curve(ax, "energy_residual", energy, "locked in", color="#009E73")
    ax.set_title("(c)  energy since the start")
    ax.set_ylabel(energy.label("", "U"))
    ax.set_ylim(top=1.3 * ax.get_ylim()[1])
    ax.legend(loc="upper left", ncol=2)

    pressure = scales.pressure(largest("max_pressure"))
    ax = panels[1, 0]
    curve(ax, "max_pressure", pressure, "largest pressure", color=style.LOWER)
    ax.set_title("(d)  largest pressure")
    ax.set_ylabel(pressure.label("", r"p_{\max}"))

    depth = scales.displacement(largest("max_residual_lower", "max_residual_upper"))
    ax = panels[1, 1]
    curve(ax, "max_residual_lower", depth, "lower body", **lower)
    curve(ax, "max_residual_upper", depth, "upper body", **upper)
    ax.set_title("(e)  residual depth")
    ax.set_ylabel(depth.label("", r"u^r_{\max}"))
    ax.set_ylim(top=1.2 * ax.get_ylim()[1])
    ax.legend(loc="upper left", ncol=2)

    ax = panels[1, 2]
    for x, one in zip(course, passes, strict=True):
        ax.plot(x / x_scale.size, one["iterations"], linestyle="none", marker="o", color=style.LOWER)
    ax.set_title("(f)  cost")
    ax.set_ylabel("evaluations per step")
    ax.yaxis.set_major_locator(MaxNLocator(integer=True))

    for index, ax in np.ndenumerate(panels):
        if index not in ((0, 0),):
            ax.set_ylim(bottom=min(0.0, ax.get_ylim()[0]) if index == (0, 2) else 0.0)
        for x in course[1:]:
            ax.axvline(x[0] / x_scale.size, color="0.8", linewidth=0.8, zorder=0.5)
        if not several:
            ax.axvline(0.0, color="0.8", linewidth=0.8, zorder=0.5)
    for ax in panels[1]:
        ax.xaxis.set_major_locator(MaxNLocator(nbins=5, steps=[1, 2, 5, 10]))
        ax.set_xlabel(x_label)
    return fig
