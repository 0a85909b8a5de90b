# SPDX-License-Identifier: BSD-3-Clause
"""Fatigue under the surface: a map in the section through the worst point, and profiles over the depth."""

from __future__ import annotations

import numpy as np
from matplotlib.figure import Figure
from matplotlib.patheffects import withStroke

from brinell.plot import style
from brinell.plot.scales import si
from brinell.results import Fatigue, FatiguePlace, Run

__all__ = ["fatigue_under_surface"]


@style.figure
def fatigue_under_surface(run: Run, fatigue: Fatigue, *, ax: style.Target | None = None) -> Figure:
    """Utilisation, or the orthogonal shear without a criterion, in the section y = const through its worst point.

    Beside it, the largest values over the depth. A cross marks the worst point.

    Args:
        run: the run.
        fatigue: of one of its bodies, `run.fatigue("lower")`.
        ax: axes of the caller, one per panel, or a figure, to draw into; None: a new figure.

    Raises:
        RunError: the fields of fatigue are not stored.
    """
    judged = fatigue.utilisation is not None
    name = "utilisation" if judged else "orthogonal_shear"
    worst: FatiguePlace = fatigue.utilisation or fatigue.orthogonal_shear
    field = fatigue.field(name)
    section = field.sel(y=worst.y, method="nearest")
    x, z = section.coords["x"], section.coords["z"]
    along, depth = si(abs(x).max(), "m"), si(z.max(), "m")
    unit = None if judged else si(worst.value, "Pa")
    size, text = (
        (1.0, "utilisation") if unit is None else (unit.size, unit.label("orthogonal shear amplitude", r"\tau_0"))
    )
    fig = style.new_figure(9.6, 3.6)
    left, right = fig.subplots(1, 2, width_ratios=[1.6, 1.0])
    image = left.pcolormesh(x / along.size, z / depth.size, section.values / size, cmap=style.STRESS_MAP)
    left.plot(worst.x / along.size, worst.depth / depth.size, "x", color="black")
    left.invert_yaxis()
    left.set_xlabel(along.label("", "x"))
    left.set_ylabel(depth.label("depth", "z"))
    left.set_title(f"{fatigue.body} body, y = {style.quantity(worst.y, 'm') if abs(worst.y) > 1e-12 else '0'}")
    fig.colorbar(image, ax=left, label=text)
    if np.isnan(section.values).any():
        note = left.text(0.02, 0.02, "white: not evaluated", transform=left.transAxes, fontsize=style.font(8))
        note.set_path_effects([withStroke(linewidth=2.0, foreground="white", alpha=0.8)])
    layers, values = fatigue.depth_profile(name)
    right.plot(layers / depth.size, values / size, color=style.LOWER if fatigue.body == "lower" else style.UPPER)
    right.set_xlim(left=0.0)
    right.set_xlabel(depth.label("depth", "z"))
    right.set_ylabel(text)
    right.set_title(f"largest in each layer, cycle {fatigue.cycle}")
    fig.suptitle(f"Fatigue of the {fatigue.body} body: {fatigue.shakedown.replace('_', ' ')}", fontsize=style.font(10))
    return fig
