# SPDX-License-Identifier: BSD-3-Clause
"""Sliding: number, size and place of the patches of the contact."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from matplotlib.axes import Axes
from matplotlib.axis import Axis
from matplotlib.colors import LogNorm
from matplotlib.figure import Figure
from matplotlib.ticker import FuncFormatter, LogLocator, NullFormatter
from numpy.typing import NDArray

from brinell.contact import Patches
from brinell.plot import style
from brinell.plot.cells import extent
from brinell.plot.overlay import Entry, entries, legend_beside, of_runs
from brinell.plot.scales import area_scale, si
from brinell.results import Run

__all__ = ["contact_patches"]

FloatArray = NDArray[np.float64]


@style.figure
@of_runs
def contact_patches(runs: Sequence[Run], *, ax: style.Target | None = None) -> Figure | None:
    """Over the sliding distance: number of patches, and area of the largest one (dotted: their mean).

    For a single run also the patches in the last stored state that slides, and the share of patches larger than an area
    in the first and last such state.

    Returns:
        None if nothing has slid, or the results are from before patches were counted.
    """
    shown = entries(runs, "sliding")
    if any("patches" not in entry.run.history for entry in shown) or not any(_moving(e.run).any() for e in shown):
        return None
    states = _states(shown[0].run) if len(shown) == 1 else []
    fig = style.new_figure(9.6, 6.4 if states else 3.4)
    axes = fig.subplots(2 if states else 1, 2, squeeze=False)
    _draw_course(axes[0, 0], axes[0, 1], shown)
    if states:
        _draw_map(fig, axes[1, 0], shown[0].run, *states[-1])
        _draw_sizes(axes[1, 1], shown[0].run, states)
    legend_beside(axes[0, 1], [entry.look for entry in shown])
    return fig


def _moving(run: Run) -> NDArray[np.bool_]:
    return np.diff(run.history["way"], prepend=0.0) > 0.0


def _states(run: Run) -> list[tuple[int, Patches]]:
    """The first and the last of the stored steps that slide and touch, of a run that has finished."""
    if not run.complete:
        return []
    steps = [step for step in run.steps if _moving(run)[step] and run.history["patches"][step] > 0]
    return [(step, run.patches(step)) for step in sorted({steps[0], steps[-1]})] if steps else []


def _draw_course(number: Axes, size: Axes, shown: Sequence[Entry]) -> None:
    largest = max(float(entry.run.history["largest_patch"].max()) for entry in shown)
    way = si(max(float(entry.run.history["way"].max()) for entry in shown), "m")
    area = area_scale(largest)
    for entry in shown:
        moving = _moving(entry.run)
        x = entry.run.history["way"][moving] / way.size
        count = entry.run.history["patches"][moving]
        mean = np.divide(entry.run.history["contact_area"][moving], count, out=np.zeros(len(count)), where=count > 0)
        number.plot(x, count, **(entry.look | {"drawstyle": "steps-mid"}))
        size.plot(x, entry.run.history["largest_patch"][moving] / area.size, **entry.look)
        size.plot(x, mean / area.size, color=entry.look["color"], linestyle=":", linewidth=1.2)
    number.set_title("(a)  patches of the contact")
    number.set_ylabel("number")
    size.set_title("(b)  area of the largest patch; dotted, mean")
    size.set_ylabel(area.label("", "A"))
    for ax in (number, size):
        ax.set_xlabel(way.label("way slid", "s"))
        ax.set_ylim(bottom=0.0)
        ax.margins(x=0.02)


def _draw_map(fig: Figure, ax: Axes, run: Run, step: int, patches: Patches) -> None:
    contact = run.snapshot(step).contact
    length = si(float(max(np.abs(contact.x).max(), np.abs(contact.y).max())), "m")
    area = area_scale(float(patches.area.max()))
    areas = np.ma.masked_array(patches.area[np.maximum(patches.label, 0)], patches.label < 0) / area.size
    lowest, highest = float(areas.min()), float(areas.max())
    image = ax.imshow(
        areas,
        origin="lower",
        extent=extent(contact.x, contact.y, length.size),
        cmap=style.PRESSURE_MAP,
        norm=LogNorm(0.8 * lowest, 1.25 * highest),
        interpolation="nearest",
        aspect="equal",
    )
    ax.set_facecolor("0.93")
    ax.set_title(f"(c)  where they are at step {step}")
    ax.set_xlabel(length.label("", "x'"))
    ax.set_ylabel(length.label("", "y'"))
    bar = fig.colorbar(image, ax=ax, label=area.label("area of the patch", "A"), pad=0.02)
    _plain_ticks(bar.ax.yaxis)


def _draw_sizes(ax: Axes, run: Run, states: Sequence[tuple[int, Patches]]) -> None:
    area = area_scale(max(float(patches.area.max()) for _, patches in states))
    looks = ((style.LOWER, "-"), (style.REFERENCE, (0, (4, 2))))
    for (step, patches), (color, dash) in zip(states[::-1], looks, strict=False):
        sizes = np.sort(patches.area) / area.size
        share = 1.0 - np.arange(len(sizes) + 1) / len(sizes)
        ends = np.append(sizes, sizes[-1])
        ax.step(ends, share, where="pre", color=color, linestyle=dash, label=f"step {step}: {len(patches)}")
    ax.set_xscale("log")
    _plain_ticks(ax.xaxis)
    ax.set_ylim(0.0, 1.05)
    ax.set_title("(d)  share of the patches that are as large, or larger")
    ax.set_xlabel(area.label("area of a patch", "A"))
    ax.set_ylabel("share of their number")
    ax.legend()


def _plain_ticks(axis: Axis) -> None:
    """Labels an axis over a decade or two by numbers without powers of ten."""
    axis.set_major_locator(LogLocator(subs=(1.0, 2.0, 5.0)))
    axis.set_major_formatter(FuncFormatter(lambda value, _: style.number(value)))
    axis.set_minor_formatter(NullFormatter())
