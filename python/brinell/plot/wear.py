# SPDX-License-Identifier: BSD-3-Clause
"""Wear: depth that both surfaces have lost, along and across the motion, and its growth."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from matplotlib.figure import Figure
from numpy.typing import NDArray

from brinell.plot import style
from brinell.plot.overlay import Look
from brinell.plot.scales import Scale, si
from brinell.results import BodyFields, Run

__all__ = ["worn_course", "worn_profiles"]

FloatArray = NDArray[np.float64]

_LOOKS: Mapping[str, Look] = {
    "lower": {"color": style.LOWER, "linestyle": "-"},
    "upper": {"color": style.UPPER, "linestyle": (0, (4, 2))},  # often equal: both must show
}


def _worn(run: Run) -> list[tuple[str, BodyFields, FloatArray]]:
    """Bodies that have lost material at the end, and the depth."""
    final = run.snapshot("final")
    both = (("lower", final.lower), ("upper", final.upper))
    return [(side, body, w) for side, body in both if (w := body.worn_depth) is not None and np.any(w)]


@style.figure
def worn_profiles(run: Run, *, ax: style.Target | None = None) -> Figure | None:
    """The worn depth of each surface at the end, along and across the motion through its deepest place.

    In plane strain, where nothing varies across, along the motion only.

    Returns:
        None if nothing is worn.
    """
    worn = _worn(run) if run.complete else []
    if not worn:
        return None
    depth = si(max(float(w.max()) for _, _, w in worn), "m")
    length = si(max(float(np.abs(np.concatenate([body.x, body.y])).max()) for _, body, _ in worn), "m")
    panels = 1 if len(worn[0][1].y) == 1 else 2
    fig = style.new_figure(4.8 * panels, 3.5)
    axes = fig.subplots(1, panels, sharey=True, squeeze=False)[0]
    for side, body, w in worn:
        deepest = np.unravel_index(np.argmax(w), w.shape)
        for ax, x, profile in zip(axes, (body.x, body.y), (w[deepest[0]], w[:, deepest[1]]), strict=False):
            ax.plot(x / length.size, profile / depth.size, label=side, **_LOOKS[side])
    axes[0].set_ylabel(depth.label("worn depth", "w"))
    axes[0].set_ylim(bottom=0.0)
    axes[0].invert_yaxis()
    for ax, title, symbol in zip(axes, ("(a)  along the motion", "(b)  across"), "xy", strict=False):
        ax.set_title(title if panels > 1 else "along the motion")
        ax.set_xlabel(length.label("", symbol))
        ax.margins(x=0.02)
    axes[-1].legend()
    return fig


def _way(run: Run) -> tuple[FloatArray, str]:
    """Abscissa of the growth of wear, as far as the history has one, and its name."""
    history = run.history
    if "way" in history:
        return history["way"], "way slid"
    if "displacement" in history:
        return np.cumsum(np.abs(np.diff(history["displacement"], prepend=0.0))), "way to and fro"
    if "theta" in history:  # of two asperities; the way back from pass to pass is without contact
        distance = np.hypot(history["X"], history["height"])  # of the centres
        slid = distance[1:] * np.diff(history["theta"])
        return np.cumsum(np.append(0.0, np.where(np.diff(history["pass"]) == 0, slid, 0.0))), "way slid"
    return history["step"].astype(float), "step"


def _volume(largest: float) -> Scale:
    """Scale of volumes in SI without a prefix, which would apply to the length and not to the volume."""
    for size, unit in ((1e-9, "mm³"), (1e-18, "µm³")):
        if largest >= 0.01 * size:
            return Scale(size, "", unit)
    return Scale(1e-27, "", "nm³")


@style.figure
def worn_course(run: Run, *, ax: style.Target | None = None) -> Figure | None:
    """The volume that each body has lost, and its largest depth, over the distance.

    Returns:
        None if nothing is worn.
    """
    history = run.history
    sides = [side for side in _LOOKS if np.any(history.get(f"worn_volume_{side}", 0.0))]
    if not sides:
        return None
    x, name = _way(run)
    way = si(float(x.max()), "m") if name != "step" else Scale(1.0, "", "")
    volume = _volume(max(float(history[f"worn_volume_{side}"].max()) for side in sides))
    depth = si(max(float(history[f"max_worn_depth_{side}"].max()) for side in sides), "m")
    fig = style.new_figure(9.6, 3.5)
    lost, deep = fig.subplots(1, 2, sharex=True)
    for side in sides:
        lost.plot(x / way.size, history[f"worn_volume_{side}"] / volume.size, label=side, **_LOOKS[side])
        deep.plot(x / way.size, history[f"max_worn_depth_{side}"] / depth.size, label=side, **_LOOKS[side])
    lost.set_title("(a)  worn volume")
    lost.set_ylabel(volume.label("", "V"))
    deep.set_title("(b)  deepest place of the surface")
    deep.set_ylabel(depth.label("worn depth", "w"))
    for ax in (lost, deep):
        ax.set_xlabel(way.label(name, "s") if name != "step" else "step")
        ax.set_ylim(bottom=0.0)
        ax.margins(x=0.02)
    lost.legend()
    return fig
