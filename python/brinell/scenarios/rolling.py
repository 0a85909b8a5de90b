# SPDX-License-Identifier: BSD-3-Clause
"""The scenario rolling: results, key numbers and figures."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING

from brinell.scenarios.lists import RollingPass
from brinell.scenarios.traits import Drawing, Drawings, KeyNumber, Traits
from brinell.summary import FloatArray, RunSummary

if TYPE_CHECKING:
    from brinell.plot.history import Panel
    from brinell.results import Run

__all__ = ["TRAITS", "RollingResult", "TrackProfile"]


@dataclass(frozen=True, eq=False)
class TrackProfile:
    """Depth profiles in the lower body under x = y = 0 after the last pass, unloaded; (nz,) values, one per layer."""

    depth: FloatArray
    """Depths of the middles of the layers, > 0 [m]."""
    residual_xx: FloatArray
    """Residual stress along the motion, positive in tension [Pa]."""
    residual_yy: FloatArray
    """Residual stress across the motion, positive in tension [Pa]."""
    equivalent_plastic_strain: FloatArray
    """Equivalent plastic strain [-]."""


class RollingResult(RunSummary):
    """Summary results that are specific to rolling."""

    @cached_property
    def passes(self) -> list[RollingPass]:
        """Results of each pass of a rolling run, in order of time.

        Raises:
            RunError: the run has another scenario, is unfinished, or its summary is damaged.
        """
        return self._entries_of("rolling", "passes", RollingPass)

    @cached_property
    def profile(self) -> TrackProfile:
        """Residual stress and plastic strain over the depth under the middle of the track.

        Raises:
            RunError: the run has another scenario, is unfinished, or its summary is damaged.
        """
        return self._entry_of("rolling", "profile", TrackProfile)


def _creeps(run: Run) -> bool:
    """Whether the case has creepage or spin, so that the surfaces stick and slip."""
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
        "Draw rut, strain and dissipation by pass, residual stress over depth, the cross section of the track and the "
        "forces along it; with creepage also stick, slip and heat of friction, and the creep curve of several runs.",
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
