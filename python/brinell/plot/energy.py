# SPDX-License-Identifier: BSD-3-Clause
"""Energy balance: forms of energy to which the work of the drive was converted, and the error of the balance."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator
from numpy.typing import NDArray

from brinell.plot import style
from brinell.plot.overlay import zero_line
from brinell.plot.scales import Scales, si, twin_axis
from brinell.results import History, Run

__all__ = ["SINKS", "balance_error", "energy_balance", "sinks_of"]

FloatArray = NDArray[np.float64]


@dataclass(frozen=True)
class Sink:
    """A form of energy to which work of the drive is converted."""

    column: str
    """Of the history."""
    name: str
    colour: str


SINKS = (
    Sink("dissipation_lower", "dissipated, lower body", style.CATEGORIES[0]),
    Sink("dissipation_upper", "dissipated, upper body", style.CATEGORIES[1]),
    Sink("dissipation_friction", "heat of friction", style.CATEGORIES[3]),
    Sink("work_of_wear", "spent on what is worn", style.CATEGORIES[4]),
    Sink("energy_residual", "locked in", style.CATEGORIES[2]),
    Sink("energy_elastic", "recoverable", "#BBBBBB"),
)
"""All forms of energy to which the work of the drive is converted."""


def sinks_of(history: History) -> tuple[Sink, ...]:
    """Forms of energy whose columns a history has; older histories lack friction and wear."""
    return tuple(sink for sink in SINKS if sink.column in history)


def supplied(history: History) -> FloatArray:
    """Work of the drive since the start [J], with the work that bodies do as they expand."""
    expansion = history.get("work_of_expansion", 0.0)
    return np.asarray(history["work"] + expansion, dtype=np.float64)


def balance_error(history: History) -> FloatArray:
    """Work that is unaccounted for at each step, over the largest work reached in the run [-]."""
    absorbed = np.sum([history[sink.column] for sink in sinks_of(history)], axis=0)
    most = float(np.max(np.abs(history["work"])))
    return np.asarray(
        (supplied(history) - absorbed) / most if most > 0.0 else np.zeros(history.steps), dtype=np.float64
    )


@style.figure
def energy_balance(run: Run, *, ax: style.Target | None = None) -> Figure:
    """Forms of energy to which the work of the drive was converted by step; below, the part that is unaccounted for."""
    history = run.history
    step = history["step"]
    energy = si(float(np.max(np.abs(history["work"]))), "J")
    fig = style.new_figure(7.4, 5.0)
    top, bottom = fig.subplots(2, 1, sharex=True, height_ratios=[3.0, 1.0])
    present = [sink for sink in sinks_of(history) if np.any(history[sink.column])]
    if present:
        top.stackplot(
            step,
            [history[sink.column] / energy.size for sink in present],
            labels=[sink.name for sink in present],
            colors=[sink.colour for sink in present],
            alpha=0.85,
            linewidth=0.0,
        )
    top.plot(step, history["work"] / energy.size, color="black", label="work of the drive")
    if np.any(supplied(history) != history["work"]):
        look = {"color": "black", "linestyle": ":", "label": "and of the swelling bodies"}
        top.plot(step, supplied(history) / energy.size, **look)
    top.set_ylabel(energy.label("energy", "U"))
    twin_axis(top, "y", energy, Scales(run).energy(0.0), "U")
    top.margins(x=0.0)
    handles, labels = top.get_legend_handles_labels()
    fig.legend(handles[::-1], labels[::-1], loc="outside upper center", ncol=3)
    zero_line(bottom)
    bottom.plot(step, balance_error(history) / 0.01, color=style.REFERENCE)
    bottom.set_ylabel("error  [%]")
    bottom.set_xlabel("step")
    bottom.xaxis.set_major_locator(MaxNLocator(integer=True))
    return fig
