# SPDX-License-Identifier: BSD-3-Clause
"""Heat of friction: how warm the surfaces become, and how much heat each body takes."""

from __future__ import annotations

import numpy as np
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator

from brinell.plot import style
from brinell.plot.overlay import zero_line
from brinell.plot.scales import si
from brinell.results import Run

__all__ = ["surface_temperatures"]

_SIDES = (("lower", style.LOWER, "-"), ("upper", style.UPPER, (0, (4, 2))))  # often equal: both must show


def _is_heated(run: Run) -> bool:
    """Whether heat of friction was computed."""
    return any(np.any(run.history[name]) for name in ("heat_lower", "heat_upper") if name in run.history)


@style.figure
def surface_temperatures(run: Run) -> Figure | None:
    """Step by step: the largest temperature of each surface, and the heat that has come into each body.

    Beside it, the heat that has arisen in both of their plastic work.

    Returns:
        None if no heat was computed.
    """
    if not _is_heated(run):
        return None
    history = run.history
    heat = si(max(float(np.abs(history[f"heat_{side}"]).max()) for side, _, _ in _SIDES), "J")
    fig = style.new_figure(9.6, 3.3)
    warm, taken = fig.subplots(1, 2, sharex=True)
    for side, colour, dash in _SIDES:
        look = {"color": colour, "linestyle": dash, "label": side}
        warm.plot(history["step"], history[f"max_temperature_{side}"], **look)
        taken.plot(history["step"], history[f"heat_{side}"] / heat.size, **look)
    of_work = history.get("heat_of_plastic_work", np.zeros(history.steps))
    if np.any(of_work):
        taken.plot(
            history["step"],
            of_work / heat.size,
            color=style.CATEGORIES[2],
            linestyle=":",
            label="of plastic work, both",
        )
        taken.legend()
    warm.set_title("(a)  hottest place of each surface")
    warm.set_ylabel("temperature  $T$  [°C]")
    zero_line(taken)
    taken.set_title("(b)  heat in each body since the start")
    taken.set_ylabel(heat.label("", "Q"))
    for ax in (warm, taken):
        ax.set_xlabel("step")
        ax.xaxis.set_major_locator(MaxNLocator(integer=True, nbins=6))
        ax.margins(x=0.02)
    warm.legend()
    return fig
