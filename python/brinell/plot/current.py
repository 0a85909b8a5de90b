# SPDX-License-Identifier: BSD-3-Clause
"""Electric contact: resistance over load, steps and voltage, spots, and density of the current; SI with prefixes."""

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

__all__ = [
    "contact_resistance",
    "contact_spots",
    "current_density_map",
    "has_current",
    "resistance_characteristic",
    "resistance_course",
]

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
def resistance_course(run: Run, *, ax: style.Target | None = None) -> Figure | None:
    """The electrical resistance step by step, in fretting over the cycles, and the resistance of the film beside it.

    Returns:
        None unless both bodies conduct and touch in two rows of the history.
    """
    history = run.history
    resistance = history.get("contact_resistance", np.zeros(len(history["F_n"])))
    shown = (history["F_n"] > 0.0) & (resistance > 0.0) & np.isfinite(resistance)
    if np.count_nonzero(shown) < 2:
        return None
    scale = si(float(resistance[shown].max()), "Ω")
    x, label = _cycles(run) if run.scenario == "fretting" else (history["step"].astype(float), "step")
    fig = style.new_figure(5.8, 3.8)
    ax = fig.subplots()
    ax.plot(x, np.where(shown, resistance, np.nan) / scale.size, color=style.LOWER, label="contact")
    film = history.get("film_resistance", np.zeros(len(x)))
    if np.any(film[shown] > 0.0):
        area = np.where(shown, history["contact_area"], np.nan)
        ax.plot(x, film / area / scale.size, color=style.REFERENCE, linestyle="--", label="mean film over contact area")
        ax.legend()
    ax.set_ylim(bottom=0.0)
    ax.margins(x=0.02)
    ax.set_xlabel(label)
    ax.set_ylabel(scale.label("resistance", "R"))
    return fig


def _cycles(run: Run) -> tuple[FloatArray, str]:
    """Number of cycles at the end of each step; below 0 while the bodies are pressed together."""
    cycle = run.history["cycle"]
    per_cycle = np.count_nonzero(cycle == 1)
    if per_cycle == 0:
        return run.history["step"].astype(float), "step"
    return (run.history["step"] + 1.0 - np.count_nonzero(cycle == 0)) / per_cycle, "cycles"


@style.figure
def resistance_characteristic(run: Run, *, ax: style.Target | None = None) -> Figure | None:
    """The R-U characteristic: resistance over voltage, and the temperature that belongs to the voltage.

    Returns:
        None unless the voltage of at least three steps in contact differs.
    """
    history = run.history
    if "voltage" not in history:
        return None
    voltage, resistance = history["voltage"], history["contact_resistance"]
    shown = (history["F_n"] > 0.0) & (voltage > 0.0) & np.isfinite(voltage) & np.isfinite(resistance)
    if len(np.unique(np.round(voltage[shown], 12))) < 3:
        return None
    volts, scale = si(float(voltage[shown].max()), "V"), si(float(resistance[shown].max()), "Ω")
    fig = style.new_figure(5.8, 4.0)
    ax = fig.subplots()
    ax.plot(voltage[shown] / volts.size, resistance[shown] / scale.size, marker="o", markersize=3.0, color=style.LOWER)
    ax.set_xlabel(volts.label("voltage", "U"))
    ax.set_ylabel(scale.label("resistance", "R"))
    ax.set_ylim(bottom=0.0)
    hot = ax.twinx()
    order = np.argsort(voltage[shown])
    temperature = history["contact_temperature"][shown][order]
    hot.plot(voltage[shown][order] / volts.size, temperature, color=style.REFERENCE, linestyle="--")
    hot.set_ylabel("contact temperature (dashed) in °C")
    return fig


@style.figure
@of_state
def contact_spots(run: Run, snapshot: Snapshot, *, ax: style.Target | None = None) -> Figure:
    """Spots of the contact: the share of each in the current over the share in the area.

    Spots on the line carry as much as their area; small ones that stand alone lie above it.

    Raises:
        RunError: no current flows in this state, or its density is not stored.
    """
    if not has_current(snapshot):
        raise RunError(f"{run.path}: no electric current in the state at step {snapshot.step}, so nothing to draw")
    spots = run.patches(snapshot.step)
    density = snapshot.contact.current_density
    assert density is not None
    inside = spots.label >= 0
    current = np.bincount(spots.label[inside], density[inside], minlength=len(spots.area))
    area, current = spots.area / spots.area.sum(), current / current.sum()
    fig = style.new_figure(4.8, 4.4)
    ax = fig.subplots()
    ax.plot(100.0 * area, 100.0 * current, "o", markersize=4.0, color=style.LOWER)
    ends = np.array([min(area.min(), current.min()) / 1.5, min(1.0, max(area.max(), current.max())) * 1.5])
    ax.plot(100.0 * ends, 100.0 * ends, color="gray", linewidth=1.0, linestyle=(0, (4, 2)))
    ax.set_xscale("log")
    ax.set_yscale("log")
    ax.set_xlabel("share in the contact area in %")
    ax.set_ylabel("share in the current in %")
    ax.set_title(f"{len(area)} spots:  {state_title(run, snapshot)}")
    return fig


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
