# SPDX-License-Identifier: BSD-3-Clause
"""Sliding: both surfaces before and after, with their bearing-area curves."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.image import AxesImage
from matplotlib.ticker import PercentFormatter
from numpy.typing import NDArray

from brinell.plot import style
from brinell.plot.cells import extent
from brinell.plot.overlay import of_runs, require_scenario
from brinell.plot.scales import Scale, si
from brinell.plot.surfaces import points_of_curve
from brinell.results import BodyFields, Run
from brinell.surfaces import HeightMap

__all__ = ["surfaces_before_and_after"]

FloatArray = NDArray[np.float64]


@style.figure
@of_runs
def surfaces_before_and_after(runs: Sequence[Run], *, ax: style.Target | None = None) -> Figure | None:
    """Heights before the first load and at the end, and both bearing-area curves, with Sk, Spk and Svk.

    Of one run, a row for each body with a texture.

    Returns:
        None of several runs, of a run that has not finished, or of smooth bodies.
    """
    require_scenario(runs, "sliding")
    rows = _rows(runs[0]) if len(runs) == 1 and runs[0].complete else []
    if not rows:
        return None
    fig = style.new_figure(11.0, 3.2 * len(rows) + 0.2)
    axes = fig.subplots(len(rows), 3, squeeze=False, width_ratios=(1.0, 1.0, 1.25))
    for row, (name, body, before, after) in zip(axes, rows, strict=True):
        _draw_maps(fig, row[0], row[1], name, body, before, after)
        _draw_curves(row[2], body, before, after)
    return fig


def _rows(run: Run) -> list[tuple[str, BodyFields, FloatArray, FloatArray]]:
    """Bodies with a texture, and their heights before and after."""
    final = run.snapshot("final")
    found = []
    for name, body in (("lower", final.lower), ("upper", final.upper)):
        if body.height is not None and body.height_before is not None:
            found.append((name, body, body.height_before, body.height))
    return found


def _draw_maps(
    fig: Figure, first: Axes, second: Axes, name: str, body: BodyFields, before: FloatArray, after: FloatArray
) -> None:
    length = si(float(max(np.abs(body.x).max(), np.abs(body.y).max())), "m")
    middle = float(before.mean())
    most = float(np.abs(before - middle).max())
    height = si(most, "m")

    def draw(ax: Axes, values: FloatArray) -> AxesImage:
        return ax.imshow(
            (values - middle) / height.size,
            origin="lower",
            extent=extent(body.x, body.y, length.size),
            cmap="cividis",
            vmin=-most / height.size,
            vmax=most / height.size,
            interpolation="nearest",
            aspect="equal",
        )

    draw(first, before)
    image = draw(second, after)
    first.set_title(f"{name} surface before")
    second.set_title("after")
    first.set_ylabel(length.label("", "y"))
    for ax in (first, second):
        ax.set_xlabel(length.label("", "x"))
    fig.colorbar(image, ax=[first, second], label=height.label("", "h"), pad=0.02, shrink=0.85)


def _draw_curves(ax: Axes, body: BodyFields, before: FloatArray, after: FloatArray) -> None:
    """Draws the bearing-area curves; heights count from the mean before, so that plastic flow and wear lower them."""
    height = si(float(np.abs(before - before.mean()).max()), "m")
    for values, label, color, dash in (
        (before, "before", style.REFERENCE, (0, (4, 2))),
        (after, "after", style.LOWER, "-"),
    ):
        heights = np.sort(values - before.mean(), axis=None)[::-1]
        picked = points_of_curve(heights.size)
        share = (picked + 0.5) / heights.size
        ax.plot(share, heights[picked] / height.size, color=color, linestyle=dash, label=_told(label, values, height))
    ax.xaxis.set_major_formatter(PercentFormatter(1.0, decimals=0, symbol=" %"))
    ax.set_xlim(0.0, 1.0)
    ax.set_xlabel("share of the area at that height or above")
    ax.set_ylabel(height.label("", "h"))
    ax.set_title("bearing-area curves")
    ax.legend(fontsize=style.font(8))


def _told(label: str, values: FloatArray, height: Scale) -> str:
    found = HeightMap(values, (1.0, 1.0))
    numbers = (style.number(value / height.size) for value in (found.Sk, found.Spk, found.Svk))
    return f"{label}: Sk, Spk, Svk = {', '.join(numbers)} {height.unit}"
