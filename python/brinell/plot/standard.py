# SPDX-License-Identifier: BSD-3-Clause
"""The figures that suit a run, whatever its scenario: for a first look, and for the report."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import partial
from typing import Literal

import numpy as np
from matplotlib.figure import Figure

from brinell.plot import depth, energy, fields, history, indentation, rolling
from brinell.results import Run, Snapshot

__all__ = ["Named", "standard_figures"]


@dataclass(frozen=True, eq=False)
class Named:
    """A figure with its file name and what it shows."""

    name: str
    caption: str
    """A sentence or two, for readers who see it and for those who cannot."""
    group: Literal["result", "loaded", "residual", "course", "energy"]
    """What it is about: the result of the scenario, a loaded state, what is left, step by step, or the energies."""
    figure: Figure


_INDENTATION = {
    "load-depth": "Load over the approach, all cycles; dashed, elastic spheres, if that is what touches.",
    "imprint": "Residual surface of the lower body in two planes through the first place; below, its pile-up enlarged.",
    "contact-pressure": "Contact pressure in two planes at the largest load whose fields are stored.",
    "contact-fraction": "Real contact area over the nominal one, and mean gap, over the mean pressure on the period.",
}
_ROLLING = {
    "passes": "Pass by pass: rut, shoulders, resistance, plastic strain under the track, its growth, and dissipation.",
    "depth-profiles": "Residual stress along and across the motion and plastic strain under the middle of the track.",
    "track-profile": "Residual surface of the lower body across the track, after the last pass.",
    "along-track": "Resistance and approach along the track, pass by pass.",
}


def standard_figures(run: Run) -> Iterator[Named]:
    """Draws what the run has: a run that has not finished has no final state, one without stored steps no loaded one.

    Yields:
        The figures, the most telling first.
    """
    if run.complete:
        yield from _of_scenario(run)
    if run.steps:
        yield from _of_loaded_state(run, run.snapshot("aligned"))
    if run.complete:
        yield from _of_final_state(run, run.snapshot("final", tensors=True))
    caption = "Forces, energies, permanent deformation and cost, step by step."
    yield Named("history", caption, "course", history.run_history(run))
    caption = "What the work of the drive has turned into, and below the part of it that is unaccounted for."
    yield Named("energy-balance", caption, "energy", energy.energy_balance(run))


def _of_scenario(run: Run) -> Iterator[Named]:
    """What only this scenario has."""
    if run.scenario == "tugging":
        return
    figures, captions = (
        (indentation.FIGURES, _INDENTATION) if run.scenario == "indentation" else (rolling.FIGURES, _ROLLING)
    )
    for name, draw in figures.items():
        figure = draw([run])
        if figure is not None:
            yield Named(name, captions[name], "result", figure)


def _of_loaded_state(run: Run, snapshot: Snapshot) -> Iterator[Named]:
    """The contact, and the stress under it."""
    where = "at the largest load" if run.scenario == "indentation" else "in the middle of the first pass"
    if not snapshot.in_contact:
        return
    drawn: dict[str, tuple[str, Callable[[], Figure]]] = {
        "pressure": (
            f"Contact pressure {where}, with the edge of contact.",
            partial(fields.pressure_map, run, snapshot),
        ),
        "gap": (f"Gap between the surfaces {where}, with the edge of contact.", partial(fields.gap_map, run, snapshot)),
        "section": (f"Stress and plastic strain in the plane y = 0 {where}.", partial(fields.section, run, snapshot)),
    }
    for name, (caption, draw) in drawn.items():
        yield Named(f"loaded-{name}", caption, "loaded", draw())


def _of_final_state(run: Run, snapshot: Snapshot) -> Iterator[Named]:
    """What is left when the bodies have parted; nothing if none has yielded."""
    if not any(np.any(body.equivalent_plastic_strain) for body in (snapshot.lower, snapshot.upper)):
        return
    caption = "Residual surfaces after unloading: profile on y = 0, and maps."
    yield Named("residual-surfaces", caption, "residual", fields.residual_surfaces(run, snapshot))
    caption = "Residual stress and plastic strain in the plane y = 0 after unloading."
    yield Named("residual-section", caption, "residual", fields.section(run, snapshot))
    if any(np.any(stress) for body in (snapshot.lower, snapshot.upper) for stress in body.stress.values()):
        x = float(run.history["x"][0]) if run.scenario == "indentation" else 0.0
        under = "the first place" if run.scenario == "indentation" else "the point x = y = 0"
        caption = f"Residual stress and plastic strain over the depth under {under}."
        yield Named("residual-depth", caption, "residual", depth.stress_over_depth(run, snapshot, x=x))
