# SPDX-License-Identifier: BSD-3-Clause
"""The figures that suit a run of any scenario: for a first look, and for the report."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import partial
from typing import Literal, get_args

import numpy as np
from matplotlib.figure import Figure

from brinell.plot import current, depth, energy, fatigue, fields, history, interfaces, points, temperature, wear
from brinell.plot.where import cutting_of, section_of, usual_place
from brinell.results import Run, Snapshot
from brinell.scenarios import SCENARIOS

__all__ = ["Named", "standard_figures"]


@dataclass(frozen=True, eq=False)
class Named:
    """A figure with its file name and caption."""

    name: str
    caption: str
    """A sentence or two, for readers who see it and for those who cannot."""
    group: Literal["result", "loaded", "end", "residual", "course", "energy"]
    """What it is about: the result of the scenario, a loaded state, the end of a run that leaves the bodies pressed
    together, what is left after unloading, step by step, or the energies."""
    figure: Figure


def standard_figures(run: Run) -> Iterator[Named]:
    """Draws the figures for which a run has data.

    An unfinished run has no final state, a run without stored steps no loaded one.

    Yields:
        The figures, the most telling first.
    """
    if run.complete:
        yield from _of_scenario(run)
    if run.steps:
        yield from _of_loaded_state(run, run.snapshot("aligned"))
    if run.complete:
        final = run.snapshot("final", tensors=True)
        yield from _of_final_state(run, final)
        yield from _of_fatigue(run)
        if (worn := wear.worn_profiles(run)) is not None:
            caption = "Depth that both surfaces have lost, along and across."
            yield Named("worn-profiles", caption, _end_of(final), worn)
    caption = "Forces, energies, permanent deformation and cost, step by step."
    yield Named("history", caption, "course", history.run_history(run))
    for name, of_steps, draw in _OVER_STEPS:
        if (figure := draw(run)) is not None:
            yield Named(name, of_steps, "course", figure)
    caption = "What the work of the drive has turned into, and below the part of it that is unaccounted for."
    yield Named("energy-balance", caption, "energy", energy.energy_balance(run))


_OVER_STEPS: tuple[tuple[str, str, Callable[[Run], Figure | None]], ...] = (
    (
        "point-histories",
        "Stress, plastic strain and temperature at the points of output.points, step by step.",
        points.point_histories,
    ),
    (
        "surface-temperatures",
        "Over the distance: temperature of the hottest place of each surface, and heat that each body has taken.",
        temperature.surface_temperatures,
    ),
    (
        "worn-course",
        "Volume that each body has lost by wear, and the largest depth, over the way slipped.",
        wear.worn_course,
    ),
    (
        "contact-resistance",
        "Electrical resistance over the load, with the power laws of simple contacts.",
        current.contact_resistance,
    ),
    (
        "resistance-course",
        "Electrical resistance step by step, in fretting over the cycles.",
        current.resistance_course,
    ),
    (
        "resistance-characteristic",
        "Resistance and temperature of the contact over the voltage.",
        current.resistance_characteristic,
    ),
)
"""Figures over the steps, each where the run has data for it: name, caption and function."""


def _of_fatigue(run: Run) -> Iterator[Named]:
    """Fatigue of the bodies for which it was computed and stored."""
    bodies: tuple[Literal["lower", "upper"], ...] = get_args(Literal["lower", "upper"])
    for body in bodies:
        if body not in (run.summary or {}).get("fatigue", {}):
            continue
        if not any(name.startswith("fatigue_") for name in run.field_names(body)):
            continue
        caption = f"Fatigue of the {body} body in the section through its worst point, and over the depth."
        yield Named(f"fatigue-{body}", caption, "result", fatigue.fatigue_under_surface(run, run.fatigue(body)))


def _moves(run: Run) -> bool:
    """Whether the contact moves."""
    return SCENARIOS[run.scenario].motion is not None


def _of_scenario(run: Run) -> Iterator[Named]:
    """Figures that only this scenario has."""
    drawings = SCENARIOS[run.scenario].drawings
    for name, drawing in drawings().figures.items() if drawings is not None else ():
        figure = drawing.draw([run]) if drawing.caption else None
        if figure is not None:
            yield Named(name, drawing.caption, "result", figure)


def _place_of_loaded_state(run: Run) -> str:
    traits = SCENARIOS[run.scenario]
    return "in the middle of the first pass" if traits.motion else f"at the largest {_LARGEST[traits.largest]}"


_LARGEST = {"F_n": "load", "displacement": "displacement", "way": "way slid"}
"""In words."""


def _of_loaded_state(run: Run, snapshot: Snapshot) -> Iterator[Named]:
    """Figures of the contact and of the stress under it."""
    where = _place_of_loaded_state(run)
    if not snapshot.in_contact:
        return
    drawn: dict[str, tuple[str, Callable[[], Figure]]] = {
        "pressure": (
            f"Contact pressure {where}, with the edge of contact.",
            partial(fields.pressure_map, run, snapshot),
        ),
        "gap": (f"Gap between the surfaces {where}, with the edge of contact.", partial(fields.gap_map, run, snapshot)),
        "section": (
            f"Stress and plastic strain in the plane {section_of(snapshot).text()} {where}.",
            partial(fields.section, run, snapshot),
        ),
    }
    for name, (caption, draw) in drawn.items():
        if not fields.suits(name, snapshot):
            continue
        yield Named(f"loaded-{name}", caption, "loaded", draw())
    yield from _of_interfaces(run, snapshot)
    yield from _of_heat(run, snapshot)


def _of_interfaces(run: Run, snapshot: Snapshot) -> Iterator[Named]:
    """Tractions on the interfaces of each coated body whose stress is stored."""
    bodies: tuple[Literal["lower", "upper"], ...] = get_args(Literal["lower", "upper"])
    for body in bodies:
        if not (snapshot.lower if body == "lower" else snapshot.upper).stress:
            continue
        if (figure := interfaces.interface_tractions(run, snapshot, body=body)) is not None:
            caption = (
                f"Shear and normal traction on the interfaces of the {body} body {_place_of_loaded_state(run)}; "
                "dashed, where drawn: the largest of all stored states."
            )
            yield Named(f"loaded-interfaces-{body}", caption, "loaded", figure)


def _of_heat(run: Run, snapshot: Snapshot) -> Iterator[Named]:
    """Figures of heat in a loaded state: temperatures and heat fluxes of the surfaces, and temperature over depth."""
    where = _place_of_loaded_state(run)
    if fields.suits("surface-temperature-maps", snapshot):
        caption = f"Temperatures of both surfaces and heat flux into each body {where}, with the edge of contact."
        maps = temperature.surface_temperature_maps(run, snapshot)
        yield Named("surface-temperature-maps", caption, "loaded", maps)
    if fields.suits("temperature", snapshot):
        caption = f"Temperature in the plane {section_of(snapshot).text()} {where}."
        yield Named("loaded-temperature", caption, "loaded", temperature.temperature_section(run, snapshot))


def _end_of(final: Snapshot) -> Literal["end", "residual"]:
    """Words for the final state: fretting ends under load, most scenarios without."""
    return "end" if final.in_contact else "residual"


def _of_final_state(run: Run, snapshot: Snapshot) -> Iterator[Named]:
    """Figures of the final state, in most scenarios without contact; none if no body has yielded."""
    bodies = (snapshot.lower, snapshot.upper)
    if not any(body.has_yielded or body.is_dented for body in bodies):
        return
    when, kind = ("at the end, under load", "Stress") if snapshot.in_contact else ("after unloading", "Residual stress")
    caption = f"Residual surfaces {when}: profile on {cutting_of(snapshot).text()}, and maps."
    if fields.suits("residual-surfaces", snapshot):
        yield Named("residual-surfaces", caption, _end_of(snapshot), fields.residual_surfaces(run, snapshot))
    caption = f"{kind} and plastic strain in the plane {section_of(snapshot).text()} {when}."
    if fields.suits("section", snapshot):
        yield Named("residual-section", caption, _end_of(snapshot), fields.section(run, snapshot))
    with_depth = [body for body in bodies if body.stress and body.has("equivalent_plastic_strain") and body.z.size > 1]
    if any(np.any(stress) for body in with_depth for stress in body.stress.values()):
        has_places = not _moves(run) and "x" in run.history
        first, under = (float(run.history["x"][0]), "the first place") if has_places else (0.0, "the point x = y = 0")
        x, y = usual_place(snapshot, first)
        if (x, y) != (first, 0.0):
            under = "the largest plastic strain"
        caption = f"{kind} and plastic strain over the depth under {under}{', under load' * snapshot.in_contact}."
        yield Named("residual-depth", caption, _end_of(snapshot), depth.stress_over_depth(run, snapshot, x=x, y=y))
