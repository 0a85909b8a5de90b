# SPDX-License-Identifier: BSD-3-Clause
"""Outlines of inclusions in sections."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from matplotlib.axes import Axes
from matplotlib.patheffects import withStroke

from brinell.plot.cuts import Cut, Origin, round_contact
from brinell.plot.planes import Plane, on_plane

__all__ = ["draw_inclusions"]


def draw_inclusions(
    ax: Axes, cuts: Sequence[Cut], plane: Plane, origin: Origin, length: float, *, turned: bool = False
) -> None:
    """Draws the outlines of inclusions whose cells are stored into a section.

    Args:
        ax: of the section.
        cuts: the bodies in it.
        plane: that of the section.
        origin: where x is counted from.
        length: size of the unit [m].
        turned: whether the cuts are those of a period, turned round to the contact (`round_contact`).
    """
    for cut in cuts:
        body = cut.side.body
        if body.inclusion is None:
            continue
        coordinates = {"x": body.x - origin(cut.side), "y": body.y, "z": body.z}
        for number in np.unique(body.inclusion[body.inclusion > 0.0]):
            inside = on_plane(coordinates[plane.axis], np.asarray(body.inclusion == number, dtype=np.float64), plane)
            if inside is None or min(inside.shape) < _FEWEST or not inside.max() > _LEVEL:
                continue
            across = coordinates["y" if plane.axis == "x" else "x"]
            upward = body.y if plane.axis == "z" else cut.side.up * body.z
            drawn_cut = Cut(cut.side, across, upward, inside)
            if turned:
                drawn_cut = round_contact(drawn_cut)
            drawn = ax.contour(
                drawn_cut.across / length,
                drawn_cut.upward / length,
                drawn_cut.values,
                levels=[_LEVEL],
                colors="white",
                linewidths=0.8,
                linestyles="--",
            )
            drawn.set_path_effects([withStroke(linewidth=1.8, foreground="0.3")])


_FEWEST = 2
"""Cells along either axis without which there is no outline."""
_LEVEL = 0.5
"""Between the cells of the inclusion and those around it."""
