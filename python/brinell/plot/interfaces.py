# SPDX-License-Identifier: BSD-3-Clause
"""Interfaces between the layers of coated bodies."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import accumulate

import tomllib
from matplotlib.axes import Axes
from matplotlib.patheffects import withStroke

from brinell.plot.cuts import Cut
from brinell.plot.states import Side
from brinell.results import Run, RunError

__all__ = ["draw_interfaces", "interfaces_of", "mark_interfaces"]


def interfaces_of(run: Run, side: Side) -> list[float]:
    """Depths of the interfaces of a body [m], from the surface down; empty for a homogeneous one."""
    try:
        case = tomllib.loads(run.case_text)  # also of a run that has not finished
    except RunError:
        return []
    layers = case.get(side.name.split()[0], {}).get("material", {}).get("layers", [])
    return list(accumulate(layer["thickness"] for layer in ([layers] if isinstance(layers, dict) else layers)))


def draw_interfaces(ax: Axes, run: Run, cuts: Sequence[Cut], length: float) -> None:
    """Draws the interfaces into a section normal to the surface. `length`: size of the unit of the axes [m]."""
    for cut in cuts:
        for depth in interfaces_of(run, cut.side):
            line = ax.axhline(cut.side.up * depth / length, color="white", linewidth=0.8, linestyle="--")
            line.set_path_effects([withStroke(linewidth=1.8, foreground="0.3")])


def mark_interfaces(ax: Axes, run: Run, side: Side, depth: float) -> None:
    """Marks the interfaces on an axis of depths. `depth`: size of its unit [m]."""
    for one in interfaces_of(run, side):
        ax.axvline(one / depth, color="0.5", linewidth=0.8, linestyle="--")
