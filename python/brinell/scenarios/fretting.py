# SPDX-License-Identifier: BSD-3-Clause
"""Fretting: all that Python knows of it alone."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any

from brinell.bodies import Body, Quantity
from brinell.scenarios._case import ScenarioCase
from brinell.scenarios.traits import Drawing, Drawings, KeyNumber, Traits
from brinell.settings import Grid, Interface, Output, Solver
from brinell.summary import RunSummary

if TYPE_CHECKING:
    from brinell.plot.history import Panel
    from brinell.results import Run, Snapshot

__all__ = ["TRAITS", "Fretting", "FrettingCycle", "FrettingResult"]


class Fretting(ScenarioCase):
    """The upper body, pressed on the lower one, moves to and fro along it, so little that it sticks in places."""

    _table = "fretting"

    def __init__(
        self,
        lower: Body,
        upper: Body,
        *,
        load: Quantity | None = None,
        approach: Quantity | None = None,
        displacement: Quantity | None = None,
        force: Quantity | None = None,
        direction: float | str | None = None,
        cycles: int | None = None,
        steps_per_cycle: int | None = None,
        press_steps: int | None = None,
        interface: Interface | Mapping[str, Any] | None = None,
        title: str | None = None,
        grid: Grid | Mapping[str, Any] | None = None,
        solver: Solver | Mapping[str, Any] | None = None,
        output: Output | Mapping[str, Any] | None = None,
    ):
        """Describes a fretting; one of load and approach is given, and one of displacement and force.

        Args:
            lower: the body at rest.
            upper: the body that is pressed on it and moved to and fro.
            load: reached first, and kept then.
            approach: instead of a load.
            displacement: amplitude by which distant points of the upper body move past those of the lower one: to it,
                to its opposite and back to the middle in each cycle.
            force: instead, amplitude of the force along the surface; less than friction times load.
            direction: of the motion, from x towards y, in degrees or with a unit, "1.2 rad".
            cycles: how often the upper body goes to and fro.
            steps_per_cycle: a multiple of 4.
            press_steps: in which load or approach is reached.
            interface: friction, `brinell.Interface` or a dictionary.
            title: copied into the results.
            grid: its cells, `brinell.Grid` or a dictionary.
            solver: `brinell.Solver` or a dictionary.
            output: what is stored, `brinell.Output` or a dictionary.

        Raises:
            InputError: with all problems found.
        """
        table = {
            "load": load,
            "approach": approach,
            "displacement": displacement,
            "force": force,
            "direction": direction,
            "cycles": cycles,
            "steps_per_cycle": steps_per_cycle,
            "press_steps": press_steps,
        }
        super().__init__(lower, upper, table, title=title, grid=grid, solver=solver, output=output, interface=interface)


@dataclass(frozen=True)
class FrettingCycle:
    """One cycle, from the middle over both turns back to the middle."""

    cycle: int
    """Which one; counts from 1."""
    work: float
    """Of the force along the surface: the area of the loop [J]."""
    dissipation_friction: float
    """Heat of friction in this cycle [J]."""
    dissipation_plastic: float
    """Plastic work in both bodies in this cycle [J]."""
    max_force: float
    """Largest size of the force along the surface [N]."""
    max_displacement: float
    """Largest size of the displacement [m]."""
    slip_amplitude: float
    """A quarter of the way slipped in this cycle, where that grows longest [m]."""
    stick_share: float
    """Smallest share of the contact that sticks [-]."""
    max_equivalent_plastic_strain: float
    """Largest over both bodies, at the end of the cycle [-]."""


class FrettingResult(RunSummary):
    """What only a fretting has in its summary."""

    @cached_property
    def cycles(self) -> list[FrettingCycle]:
        """Of a fretting, those that are complete, in the order of time."""
        return self._entries_of("fretting", "cycles", FrettingCycle)


def _key_numbers(run: Run) -> Iterator[KeyNumber]:
    history = run.history
    yield KeyNumber("Largest load", float(history["F_n"].max()), "N", "load")
    yield KeyNumber("Largest displacement", float(abs(history["displacement"]).max()), "m", "interference")
    yield KeyNumber("Largest force along the surface", float(abs(history["force"]).max()), "N", "load")
    yield KeyNumber("Heat of friction", float(history["dissipation_friction"][-1]), "J", "energy")
    if run.complete and run.cycles:
        last = run.cycles[-1]
        yield KeyNumber("Cycles", len(run.cycles))
        yield KeyNumber("Area of the loop, last cycle", last.work, "J", "energy")
        yield KeyNumber("Plastic dissipation, last cycle", last.dissipation_plastic, "J", "energy")
        yield KeyNumber("Slip amplitude, last cycle", last.slip_amplitude, "m")
        yield KeyNumber("Smallest share that sticks, last cycle", last.stick_share, "%")


def _state_text(run: Run, snapshot: Snapshot) -> list[str]:
    from brinell.plot import style

    row = snapshot.row
    if not row["cycle"]:
        return ["pressing", f"$F_n$ = {style.quantity(row['F_n'], 'N')}"]
    return [
        f"cycle {int(row['cycle'])}",
        rf"$\delta$ = {style.length(row['displacement'])}",
        f"$Q$ = {style.quantity(row['force'], 'N') if row['force'] else 0}",
    ]


def _panels() -> tuple[Panel, Panel]:
    from brinell.plot import history

    return history.force_along_surface, history.shares_of_contact


def _drawings() -> Drawings:
    from brinell.plot import fretting

    return Drawings(
        "fretting",
        "Loops of force over displacement, stick, slip, shear and heat of friction over the contact, cycle by cycle, "
        "step by step.",
        {
            "loops": Drawing(
                fretting.force_loops,
                "Force along the surface over the displacement, cycle by cycle; dashed, friction times load.",
            ),
            "contact-maps": Drawing(
                fretting.contact_maps,
                "Pressure with the shear on the lower body as arrows, what sticks and what slips, shear and slip, "
                "at the first turn.",
            ),
            "contact-profiles": Drawing(
                fretting.contact_profiles,
                "Along the motion through the middle of the contact: the shear between the bounds of friction, and the "
                "slip.",
            ),
            "contact-heat": Drawing(
                fretting.contact_heat,
                "Energy that friction has dissipated per area from the start to the last turn, with the edges of the "
                "contact and of what sticks.",
            ),
            "cycles": Drawing(
                fretting.cycle_by_cycle,
                "Cycle by cycle: heat of friction, plastic dissipation, force, slip, what sticks, and plastic strain.",
            ),
            "course": Drawing(
                fretting.fretting_course,
                "Step by step: displacement, force, what sticks, energies, and approach or load.",
            ),
        },
    )


TRAITS = Traits(
    name="fretting",
    motion=None,
    largest="displacement",
    continuous=True,
    key_numbers=_key_numbers,
    panels=_panels,
    drawings=_drawings,
    state_text=_state_text,
)
