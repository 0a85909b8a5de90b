# SPDX-License-Identifier: BSD-3-Clause
"""Rolling: all that Python knows of it alone."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any

from brinell.bodies import Body, Quantity
from brinell.scenarios._case import ScenarioCase
from brinell.scenarios.traits import Drawing, Drawings, KeyNumber, Traits
from brinell.settings import Grid, Heating, Interface, Output, Solver
from brinell.summary import FloatArray, RunSummary

if TYPE_CHECKING:
    from brinell.plot.history import Panel
    from brinell.results import Run

__all__ = ["TRAITS", "Rolling", "RollingPass", "RollingResult", "TrackProfile"]


class Rolling(ScenarioCase):
    """The upper body, pressed on the lower one, rolls over it along x, pass after pass."""

    _table = "rolling"

    def __init__(
        self,
        lower: Body,
        upper: Body,
        distance: Quantity,
        *,
        load: Quantity | None = None,
        hertz_pressure: Quantity | None = None,
        approach: Quantity | None = None,
        passes: int | None = None,
        slide_to_roll: float | None = None,
        creepage: Quantity | Sequence[Quantity] | None = None,
        spin: Quantity | None = None,
        shift: Quantity | None = None,
        load_steps: int | None = None,
        speed: Quantity | None = None,
        interface: Interface | Mapping[str, Any] | None = None,
        thermal: Heating | Mapping[str, Any] | None = None,
        title: str | None = None,
        grid: Grid | Mapping[str, Any] | None = None,
        solver: Solver | Mapping[str, Any] | None = None,
        output: Output | Mapping[str, Any] | None = None,
    ):
        """Describes a rolling; one of load, hertz_pressure and approach is given.

        Args:
            lower: the body that is rolled over.
            upper: the body that rolls.
            distance: length of the track on the lower body.
            load: kept while rolling.
            hertz_pressure: the load by the peak pressure that it would have in elastic contact.
            approach: kept while rolling, instead of a load.
            passes: how often the track is rolled over.
            slide_to_roll: difference over mean of the speeds of both surfaces; 0: pure rolling. With friction the
                surfaces slide everywhere.
            creepage: longitudinal and lateral, or the first of them, relative speed of the upper surface over the mean
                speed, or text as "0.2 %"; with friction the surfaces stick and slip.
            spin: turn of the upper body past the lower one about the normal of the contact per distance rolled, in
                rad/m or with a unit, "0.5 rad/mm"; likewise with stick and slip.
            shift: by which the contact moves on the lower body per step.
            load_steps: in which the upper body is pressed on before a pass and lifted off after it.
            speed: of the contact over the lower body, such as "1 m/s"; needed where friction heats.
            interface: friction, `brinell.Interface` or a dictionary.
            thermal: what its heat does, `brinell.Heating` or a dictionary.
            title: copied into the results.
            grid: its cells, `brinell.Grid` or a dictionary.
            solver: `brinell.Solver` or a dictionary.
            output: what is stored, `brinell.Output` or a dictionary.

        Raises:
            InputError: with all problems found.
        """
        table = {
            "distance": distance,
            "load": load,
            "hertz_pressure": hertz_pressure,
            "approach": approach,
            "passes": passes,
            "slide_to_roll": slide_to_roll,
            "creepage": creepage,
            "spin": spin,
            "shift": shift,
            "load_steps": load_steps,
            "speed": speed,
        }
        super().__init__(
            lower,
            upper,
            table,
            title=title,
            grid=grid,
            solver=solver,
            output=output,
            interface=interface,
            thermal=thermal,
        )


@dataclass(frozen=True)
class RollingPass:
    """What one pass has left, under the middle of the track."""

    pass_: int
    """Which one; counts from 1."""
    rut_depth: float
    """Residual displacement of the lower body at x = y = 0, into the body positive [m]."""
    shoulder_height: float
    """Largest height of its residual surface in the section x = 0, outwards positive [m]."""
    max_equivalent_plastic_strain: float
    """Largest over both bodies [-]."""
    track_plastic_strain: float
    """Largest equivalent plastic strain of the lower body under x = y = 0 [-]."""
    track_plastic_increment: float
    """Largest growth of it in this pass [-]."""
    dissipation: float
    """Plastic work in both bodies in this pass [J]."""
    resistance: float
    """Energy that both bodies take up, dissipated and locked in, per length over the middle half of the track [N]."""
    max_pressure: float
    """Mean over the same of the largest pressure [Pa]."""
    steady: bool = False
    """Whether the resistance was the same all along: then it does not depend on the length of the track."""
    unsteadiness: float = math.nan
    """Difference of it between the two quarters of the middle half, over the larger of them; steady up to 0.1 [-]."""
    mean_F_X: float = math.nan
    """Mean F_X over the middle half of the track, positive if it resists the motion [N]."""
    friction: float = math.nan
    """Mean F_X over mean F_n over the same [-]."""
    contact_area: float = math.nan
    """Mean over the same [m^2]."""
    F_x: float = math.nan
    """Mean over the last quarter of the track of the force on the lower body along x, by the shear between the surfaces
    [N]."""
    F_y: float = math.nan
    """Mean over the same of that along y [N]."""
    M_z: float = math.nan
    """Mean over the same of the moment of that shear about the normal of the contact, from x to y [N m]."""
    stick_share: float = math.nan
    """Mean over the same of the share of the contact that sticks; 0 without creepage [-]."""
    creep_steady: bool = False
    """Whether these forces were the same all along: then they are those of steady rolling."""
    creep_unsteadiness: float = math.nan
    """Difference of the force between both halves of that quarter, over the larger of them; steady up to 0.01 [-]."""


@dataclass(frozen=True, eq=False)
class TrackProfile:
    """Under x = y = 0 of the lower body after the last pass, unloaded; one value per layer of cells."""

    depth: FloatArray
    """Of the layers' centres, > 0 [m]."""
    residual_xx: FloatArray
    """Residual stress along the motion, positive in tension [Pa]."""
    residual_yy: FloatArray
    """Residual stress across it, positive in tension [Pa]."""
    equivalent_plastic_strain: FloatArray
    """[-]."""


class RollingResult(RunSummary):
    """What only a rolling has in its summary."""

    @cached_property
    def passes(self) -> list[RollingPass]:
        """Of a rolling, in the order of time."""
        return self._entries_of("rolling", "passes", RollingPass)

    @cached_property
    def profile(self) -> TrackProfile:
        """What rolling has left in the depth under the middle of the track."""
        return self._entry_of("rolling", "profile", TrackProfile)


def _creeps(run: Run) -> bool:
    """Whether the surfaces stick and slip."""
    return run.case("rolling", "creepage") is not None or run.case("rolling", "spin") is not None


def _key_numbers(run: Run) -> Iterator[KeyNumber]:
    yield KeyNumber("Largest load", float(run.history["F_n"].max()), "N", "load")
    if run.complete:
        last = run.passes[-1]
        yield KeyNumber("Passes", len(run.passes))
        yield KeyNumber("Rut depth after the last pass", last.rut_depth, "m", "interference")
        yield KeyNumber("Height of its shoulders", last.shoulder_height, "m", "interference")
        steady = "" if last.steady else ", not steady"
        yield KeyNumber(f"Resistance, last pass{steady}", last.resistance, "N", "load")
        yield KeyNumber("Growth of strain in the last pass", last.track_plastic_increment, "%")
        if _creeps(run) and not math.isnan(last.F_x):
            on_the_way = "" if last.creep_steady else ", not steady"
            yield KeyNumber(f"Force along the motion, last pass{on_the_way}", last.F_x, "N", "load")
            yield KeyNumber(f"Force across it, last pass{on_the_way}", last.F_y, "N", "load")
            yield KeyNumber("Share that sticks, last pass", last.stick_share, "%")
            yield KeyNumber("Heat of friction", float(run.history["dissipation_friction"][-1]), "J", "energy")
        if run.case("rolling", "slide_to_roll") and not math.isnan(last.friction):
            yield KeyNumber("Friction F_X / F_n, last pass", last.friction)
            yield KeyNumber("Area of contact, last pass", last.contact_area, "m²")


def _panels() -> tuple[Panel, Panel]:
    from brinell.plot import history

    return history.resistance_to_rolling, history.approach


def _drawings() -> Drawings:
    from brinell.plot import creepage, rolling

    return Drawings(
        "rolling",
        "Rut, strain and dissipation by pass, residual stress in depth, the track across, forces along it; with "
        "creepage stick, slip and heat of friction, and of several runs the creep curve.",
        {
            "passes": Drawing(
                rolling.pass_by_pass,
                "Pass by pass: rut, shoulders, resistance, plastic strain under the track, its growth, and "
                "dissipation.",
            ),
            "depth-profiles": Drawing(
                rolling.depth_profiles,
                "Residual stress along and across the motion and plastic strain under the middle of the track.",
            ),
            "track-profile": Drawing(
                rolling.track_profile,
                "Residual surface of the lower body across the track, after the last pass.",
            ),
            "along-track": Drawing(rolling.along_track, "Resistance and approach along the track, pass by pass."),
            "creep-forces": Drawing(
                rolling.creep_forces,
                "With creepage: forces and moment between the surfaces over friction times load, and the share of the "
                "contact that sticks, over the distance rolled.",
            ),
            "creep-curve": Drawing(creepage.creep_curve),
            "contact-maps": Drawing(
                rolling.creep_maps,
                "With creepage: pressure with the shear on the lower body as arrows, what sticks and what slips, shear "
                "and slip, in the middle of the track.",
            ),
            "contact-heat": Drawing(
                rolling.creep_heat,
                "With creepage: energy that friction has dissipated per area since each place came under the contact, "
                "in the middle of the track, with the edges of the contact and of what sticks.",
            ),
            "contact-profiles": Drawing(
                rolling.creep_profiles,
                "With creepage: the shear between the bounds of friction along the motion through the middle of the "
                "contact, and the slip.",
            ),
        },
    )


TRAITS = Traits(name="rolling", motion="x", key_numbers=_key_numbers, panels=_panels, drawings=_drawings)
