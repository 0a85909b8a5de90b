# SPDX-License-Identifier: BSD-3-Clause
"""Rough surfaces over a period: real contact, mean gap and stiffness over the mean pressure.

The pressure is shown over E' times the rms slope of both textures together where all runs have these, so that surfaces
of any steepness and material lie on each other; with two lines of theory then: Persson (2001) and Bush, Gibson, Thomas
(1975).
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from numpy.typing import NDArray

from brinell.plot import style
from brinell.plot.overlay import Entry, entries, largest, legend_beside, of_runs
from brinell.plot.scales import draws_si, si
from brinell.results import Run

__all__ = ["contact_fraction"]

FloatArray = NDArray[np.float64]

PERSSON = math.sqrt(8.0 / math.pi)
"""Contact fraction over p / (E' rms slope), of little contact, in the theory of Persson."""
SUMMITS = math.sqrt(2.0 * math.pi)
"""The same of independent summits (Bush, Gibson, Thomas)."""


@dataclass(frozen=True, eq=False)
class _Closing:
    """The states of one run that are under pressure."""

    entry: Entry
    pressure: FloatArray
    """Over the period [Pa]."""
    fraction: FloatArray
    gap: FloatArray
    """[m]."""
    scale: float | None
    """E' times the rms slope [Pa]; None where either is not known."""


def _closing(entry: Entry) -> _Closing | None:
    """These states; None if the run has no period."""
    history = entry.run.history
    if "contact_fraction" not in history or np.all(np.isnan(history["contact_fraction"])):
        return None
    return _Closing(
        entry, history["nominal_pressure"], history["contact_fraction"], history["mean_gap"], _pressure_scale(entry.run)
    )


def _pressure_scale(run: Run) -> float | None:
    geometry = (run.summary or {}).get("geometry", {})
    slope, modulus = geometry.get("rms_slope"), geometry.get("contact_modulus_Pa")
    return float(slope) * float(modulus) if slope and modulus else None


_UNLOADING = {"linestyle": (0, (3, 1.5)), "linewidth": 0.9}
_DECADE = 10.0
"""Of the gap, from which on its axis is logarithmic."""


def _draw(ax: Axes, pressure: FloatArray, values: FloatArray, look: Mapping[str, Any]) -> bool:
    """Draws the history as a line; falling pressure is thin and dashed. Returns whether there is any."""
    falls = np.diff(pressure) < 0.0
    unloading = np.concatenate([[False], falls]) | np.concatenate([falls, [False]])
    loading = np.concatenate([[True], ~falls]) | np.concatenate([~falls, [False]])
    ax.plot(pressure, np.where(loading, values, np.nan), **look)
    if falls.any():
        ax.plot(pressure, np.where(unloading, values, np.nan), **{**look, **_UNLOADING, "label": None})
    return bool(falls.any())


@style.figure
@of_runs
def contact_fraction(runs: Sequence[Run], *, ax: style.Target | None = None) -> Figure | None:
    """Real contact area over the nominal one, and mean gap, over the mean pressure on the period.

    Returns None if no run has surfaces that are periodic along both axes.
    """
    closings = [one for one in map(_closing, entries(runs, "indentation")) if one is not None]
    if not closings:
        return None
    relative = not draws_si() and all(one.scale is not None for one in closings)
    pressure = si(largest(one.pressure for one in closings), "Pa")
    shown = [one.pressure / (one.scale if relative and one.scale else pressure.size) for one in closings]
    gap = si(largest(one.gap for one in closings), "m")
    fig = style.new_figure(8.6, 3.4)
    left, right = fig.subplots(1, 2)
    unloads = [
        _draw(ax, p, values, one.entry.look)
        for one, p in zip(closings, shown, strict=True)
        for ax, values in ((left, one.fraction), (right, one.gap / gap.size))
    ]
    if relative:
        p = np.linspace(0.0, largest(shown), 201)
        theory = {"color": style.REFERENCE, "linewidth": 0.9}
        persson = [math.erf(0.5 * math.sqrt(math.pi) * PERSSON * one) for one in p]
        left.plot(p, persson, label="Persson, elastic", linestyle="--", **theory)
        bound = p[p * SUMMITS <= 1.0]
        left.plot(bound, SUMMITS * bound, label="Bush, Gibson, Thomas, elastic", linestyle=":", **theory)
        left.legend(handles=left.lines[-2:], loc="lower right")
    left.set_title("(a)  real contact")
    left.set_ylabel("contact area over nominal  $A/A_0$")
    left.set_ylim(0.0, min(1.0, 1.1 * max(largest(one.fraction for one in closings), 1e-3)))
    right.set_title("(b)  mean gap")
    right.set_ylabel(gap.label("", r"\bar g"))
    gaps = np.concatenate([one.gap[one.gap > 0.0] for one in closings])
    if len(gaps) > 0 and gaps.max() >= _DECADE * gaps.min():
        right.set_yscale("log")
    name = r"mean pressure  $\bar p\,/\,(E' h'_{rms})$" if relative else pressure.label("mean pressure", r"\bar p")
    for ax in (left, right):
        ax.set_xlabel(name)
        ax.set_xlim(left=0.0)
    looks = [one.entry.look for one in closings]
    legend_beside(right, looks + [{"color": style.REFERENCE, "label": "unloading", **_UNLOADING}] * any(unloads))
    return fig
