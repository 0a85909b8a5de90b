# SPDX-License-Identifier: BSD-3-Clause
"""The scenario fretting: results, key numbers and figures."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property
from typing import TYPE_CHECKING

from brinell.scenarios.lists import FrettingCycle
from brinell.scenarios.traits import Drawing, Drawings, KeyNumber, Traits
from brinell.summary import RunSummary

if TYPE_CHECKING:
    from brinell.plot.history import Panel
    from brinell.results import Run, Snapshot

__all__ = ["TRAITS", "FrettingResult"]


class FrettingResult(RunSummary):
    """Summary results that are specific to fretting."""

    @cached_property
    def cycles(self) -> list[FrettingCycle]:
        """Results of each complete cycle of a fretting run, in order of time.

        Raises:
            RunError: the run has another scenario, is unfinished, or its summary is damaged.
        """
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
        "Draw loops of force over displacement, maps of stick, slip, shear and heat of friction, and the course by "
        "cycle and by step.",
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
