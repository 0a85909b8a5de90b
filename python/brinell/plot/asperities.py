# SPDX-License-Identifier: BSD-3-Clause
"""Maps of passing asperities, and sums over two rough surfaces (`brinell.asperities`)."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from numpy.typing import NDArray

from brinell.plot import style
from brinell.plot.scales import si

if TYPE_CHECKING:  # what draws does not need it
    from brinell.asperities import AsperityMap, AsperitySum, Estimate

__all__ = ["friction_over_load", "passes_map"]

FloatArray = NDArray[np.float64]

_POINTS = 161


@style.figure
def passes_map(
    of: AsperityMap, quantity: str = "work", ratio: float = 1.0, *, ax: style.Target | None = None
) -> Figure:
    """A result of one pass over interference and offset, and along the nodes of the map with their errors.

    All in units of the pair: alpha_c, and the way L = sqrt(2 (R1 + R2) alpha_c) of offset and pass.

    Args:
        of: the map.
        quantity: one of `brinell.asperities.QUANTITIES`.
        ratio: of the radii R1/R2.
    """
    from brinell.asperities import QUANTITIES
    from brinell.asperities.pairs import closest
    from brinell.asperities.tugging_map import turned

    about = QUANTITIES[quantity]
    lower, upper = 1.0 + ratio, (1.0 + ratio) / ratio
    alpha_c = of.pair.interference
    length = np.sqrt(2.0 * (lower + upper) * alpha_c)
    last = float(of.interferences[-1])
    a, y = np.linspace(0.0, last, _POINTS), np.linspace(0.0, 1.02 * np.sqrt(last), _POINTS)
    left, tilt = closest(a[None, :] * alpha_c, y[:, None] * length, lower + upper)
    values = of.scaled(quantity, left / alpha_c, ratio).value * turned(quantity, tilt)
    fig = style.new_figure(8.6, 3.4)
    over_both, along = fig.subplots(1, 2)
    shown = over_both.pcolormesh(a, y, np.where(left > 0.0, values, np.nan), rasterized=True)
    over_both.contour(a, y, left / alpha_c, levels=[0.0, 1.0], colors=[style.REFERENCE, "white"], linewidths=0.9)
    fig.colorbar(shown, ax=over_both, label=f"{quantity}, over its unit")
    over_both.set_title("(a)  touch (grey), first yield (white)")
    over_both.set_xlabel(r"interference  $\alpha\,/\,\alpha_c$")
    over_both.set_ylabel(r"offset  $y\,/\,\sqrt{2(R_1 + R_2)\,\alpha_c}$")
    _draw_nodes(along, of, quantity, about.power)
    along.set_title("(b)  aligned: nodes and between them")
    along.set_ylabel(rf"{quantity}, over its unit and $(\alpha/\alpha_c)^{{{style.number(about.power)}}}$")
    return fig


def _draw_nodes(ax: Axes, of: AsperityMap, quantity: str, power: float) -> None:
    line = np.geomspace(of.interferences[0], of.interferences[-1], _POINTS)
    for k, ratio in enumerate(of.ratios):
        colour = style.CATEGORIES[k % len(style.CATEGORIES)]
        ax.plot(line, of.scaled(quantity, line, ratio).value / line**power, color=colour)
        error = of.mesh_errors[quantity][k] + of.interpolation_errors[quantity][k]
        ax.errorbar(
            of.interferences,
            of.nodes[quantity][k],
            error,
            color=colour,
            fmt="o",
            capsize=2,
            label=f"$R_1/R_2$ = {style.number(float(ratio))}",
        )
    ax.set_xscale("log")
    ax.set_xlabel(r"interference  $\alpha\,/\,\alpha_c$")
    ax.legend()


@style.figure
def friction_over_load(sums: Sequence[AsperitySum], *, ax: style.Target | None = None) -> Figure | None:
    """Friction by ploughing and real contact over the mean pressure, and the pressure over the separation.

    Bars are the intervals of the sums.

    Args:
        sums: what to draw.

    Returns:
        None if nothing touches.
    """
    touching = [one for one in sums if one.pressure.value > 0.0]
    if not touching:
        return None
    pressure = _values([one.pressure for one in touching])
    fig = style.new_figure(11.0, 3.3)
    left, middle, right = fig.subplots(1, 3)
    _bars(left, pressure, [one.friction_coefficient for one in touching], style.UPPER)
    left.set_title("(a)  friction by ploughing")
    left.set_ylabel("coefficient of friction")
    left.set_ylim(bottom=0.0)
    _bars(middle, pressure, [one.contact_fraction for one in touching], style.LOWER)
    middle.set_title("(b)  real contact")
    middle.set_ylabel("contact area over nominal")
    middle.set_yscale("log")
    separation = np.array([one.separation for one in touching])
    of_gap = si(float(np.abs(separation).max()), "m")
    _bars(right, separation / of_gap.size, [one.pressure for one in touching], style.LOWER)
    right.set_title("(c)  pressure")
    right.set_ylabel("mean pressure  [Pa]")
    right.set_yscale("log")
    right.set_xlabel(of_gap.label("separation", "d"))
    for ax in (left, middle):
        ax.set_xscale("log")
        ax.set_xlabel("mean pressure  [Pa]")
    return fig


def _values(estimates: Sequence[Estimate]) -> FloatArray:
    return np.array([one.value for one in estimates])


def _bars(ax: Axes, x: FloatArray, estimates: Sequence[Estimate], colour: str) -> None:
    values = _values(estimates)
    # A logarithmic axis has no 0: an interval that reaches it ends just above.
    half = np.array([one.half_width for one in estimates])
    ax.errorbar(
        x,
        values,
        np.stack([np.where(values > 0.0, np.minimum(half, 0.99 * values), half), half]),
        color=colour,
        marker="o",
        capsize=2,
    )
