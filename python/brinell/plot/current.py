# SPDX-License-Identifier: BSD-3-Clause
"""Electric contact: resistance over load, and density of the current; SI with prefixes."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from matplotlib.colors import LogNorm
from matplotlib.figure import Figure
from numpy.typing import NDArray

from brinell.plot import style
from brinell.plot.cells import contact_patch, draw_cells
from brinell.plot.scales import si
from brinell.plot.sheets import lying, sheet_of
from brinell.plot.states import of_state, state_title
from brinell.results import Run, RunError, Snapshot

__all__ = ["contact_resistance", "current_density_map", "has_current"]

FloatArray = NDArray[np.float64]

_DENSITY_MAP = "cividis"


def has_current(snapshot: Snapshot) -> bool:
    """Whether the density of a current is stored, and a current flows."""
    density = snapshot.contact.current_density
    return density is not None and bool(np.any(density > 0.0))


@style.figure
def contact_resistance(run: Run, *, ax: style.Target | None = None) -> Figure | None:
    """The electrical resistance over the load, and the power laws of simple contacts through its smallest value.

    A ball that stays elastic has R ~ F^(-1/3), a spot that yields with a constant hardness R ~ F^(-1/2), and a rough
    flat whose number of spots grows in proportion to the load R ~ 1/F.

    Returns:
        None unless both bodies conduct and touch in two rows of the history.
    """
    history = run.history
    load, resistance = history["F_n"], history.get("contact_resistance", np.zeros(len(history["F_n"])))
    shown = (load > 0.0) & (resistance > 0.0) & np.isfinite(resistance)
    if np.count_nonzero(shown) < 2:
        return None
    load_scale, scale = si(float(load.max()), "N"), si(float(resistance[shown].max()), "Ω")
    fig = style.new_figure(5.4, 4.0)
    ax = fig.subplots()
    drawn = np.where(shown, resistance, np.nan) / scale.size  # a line for each loading
    ax.plot(load / load_scale.size, drawn, marker="o", markersize=3.0, color=style.LOWER, label="computed")
    ax.set_xscale("log")
    ax.set_yscale("log")
    _draw_laws(ax, load[shown] / load_scale.size, resistance[shown] / scale.size)
    ax.set_xlabel(load_scale.label("load", "F"))
    ax.set_ylabel(scale.label("resistance", "R"))
    ax.legend()
    return fig


def _draw_laws(ax: Axes, load: FloatArray, resistance: FloatArray) -> None:
    """Power laws through the smallest resistance."""
    least = int(np.argmin(resistance))
    span = np.array([load.min(), load.max()])
    bottom, top = ax.get_ylim()
    for name, exponent, dashes in (("-1/3", -1.0 / 3.0, (1, 2)), ("-1/2", -0.5, (4, 2)), ("-1", -1.0, (6, 2, 1, 2))):
        law = resistance[least] * (span / load[least]) ** exponent
        ax.plot(span, law, color="gray", linewidth=1.0, linestyle=(0, dashes), label=f"$F^{{{name}}}$")
    ax.set_ylim(bottom, top)


@style.figure
@of_state
def current_density_map(run: Run, snapshot: Snapshot, *, cells: bool = False, ax: style.Target | None = None) -> Figure:
    """Density of the electric current in the contact, mean over each cell, on a logarithmic scale.

    Args:
        run: the run of the state.
        snapshot: the state to draw; a current must flow.
        cells: as in other figures; the density is drawn in cells in any case, because it has no limit at an edge.

    Raises:
        RunError: no current flows in this state, or its density is not stored.
    """
    if not has_current(snapshot):
        raise RunError(f"{run.path}: no electric current in the state at step {snapshot.step}, so nothing to draw")
    contact = snapshot.contact
    length = si(max(np.abs(contact.x).max(), np.abs(contact.y).max()), "m")
    sheet = sheet_of(*contact_patch(contact, length.size))
    contact = lying(contact, sheet)
    ranges = contact_patch(contact, length.size)
    values = contact.current_density
    assert values is not None
    flowing = values[values > 0.0]
    density = si(float(flowing.max()), "A/m²")
    fig = sheet.new_figure()
    ax = fig.subplots()
    image = draw_cells(
        ax,
        contact.x,
        contact.y,
        np.ma.masked_less_equal(values / density.size, 0.0),
        length.size,
        cmap=_DENSITY_MAP,
        norm=LogNorm(flowing.min() / density.size, 1.001 * flowing.max() / density.size),
        interpolation="nearest",
    )
    sheet.finish(ax, length, snapshot, *ranges)
    ax.set_title(f"Density of the current:  {state_title(run, snapshot)}")
    sheet.colour_bar(fig, ax, image, density.label("", "j"))
    return fig
